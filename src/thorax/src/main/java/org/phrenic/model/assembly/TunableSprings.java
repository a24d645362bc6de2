package org.phrenic.model.assembly;

import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.model.organ.MassSpringBuilder;

/** Numbers of springs as assembled, and as they are tuned: {@code k f (l - L) + T}. */
public final class TunableSprings {
    public final int count;
    /** Ends of each spring, two a spring, caller's numbering. */
    public final int[] nodes;
    /** Length of each at rest, mm. */
    public final double[] lengthAtRest;
    /** Rest length of each as tuned, mm. */
    public final double[] restLength;
    /** What full activation takes from each as tuned, mm. */
    public final double[] shortening;

    private final Springs springs;
    private final double[] stiffness;
    private final double[] assembledStiffness;
    private final double[] assembledRest;
    private final double[] assembledShortening;

    /** @param positions of all nodes at rest, caller's order, mm */
    public TunableSprings(Springs springs, NodeLayout layout, double[] positions) {
        this.springs = springs;
        count = springs.count();
        nodes = springs.callerPairs(layout);
        assembledStiffness = springs.stiffnesses();
        assembledRest = springs.restLengths();
        assembledShortening = springs.shortenings();
        stiffness = assembledStiffness.clone();
        restLength = assembledRest.clone();
        shortening = assembledShortening.clone();
        lengthAtRest = new double[count];
        for (int e = 0; e < count; e++) {
            lengthAtRest[e] = MassSpringBuilder.distance(positions, nodes[2 * e], positions, nodes[2 * e + 1]);
        }
    }

    /**
     * Makes a spring stiffer without moving where it is at rest.
     *
     * @param factor of its stiffness as assembled
     * @param moreTension beyond its tension at rest as assembled, mN
     */
    public void set(int e, double factor, double moreTension) {
        double tension = assembledStiffness[e] * (lengthAtRest[e] - assembledRest[e]) + moreTension;
        stiffness[e] = factor * assembledStiffness[e];
        restLength[e] = lengthAtRest[e] - tension / stiffness[e];
    }

    /** Hands all numbers to the springs. */
    public void apply() {
        springs.setCoefficients(stiffness, restLength, shortening);
    }

    /** Gives the springs every number they were assembled with. */
    public void restoreAssembled() {
        springs.setCoefficients(assembledStiffness, assembledRest, assembledShortening);
    }
}
