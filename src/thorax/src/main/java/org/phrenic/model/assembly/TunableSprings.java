package org.phrenic.model.assembly;

import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.model.organ.MassSpringBuilder;

/** Stiffness, length and tension of springs, at assembly and as tuned: force {@code k f (l - L) + T}. */
public final class TunableSprings {
    public final int count;
    /** The two ends of each spring in turn, caller's numbering. */
    public final int[] nodes;
    /** Length of each spring at rest, mm. */
    public final double[] lengthAtRest;
    /** Tuned rest length of each spring, mm. */
    public final double[] restLength;
    /** Tuned shortening of each spring at full activation, mm. */
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
     * Sets the stiffness of a spring and preserves its equilibrium at rest.
     *
     * @param e number of the spring
     * @param factor of its stiffness at assembly
     * @param moreTension tension added to that at rest at assembly, mN
     */
    public void set(int e, double factor, double moreTension) {
        double tension = assembledStiffness[e] * (lengthAtRest[e] - assembledRest[e]) + moreTension;
        stiffness[e] = factor * assembledStiffness[e];
        restLength[e] = lengthAtRest[e] - tension / stiffness[e];
    }

    /** Applies all values to the springs. */
    public void apply() {
        springs.setCoefficients(stiffness, restLength, shortening);
    }

    /** Restores all values at assembly. */
    public void restoreAssembled() {
        springs.setCoefficients(assembledStiffness, assembledRest, assembledShortening);
    }
}
