package org.phrenic.simulation;

import org.phrenic.engine.NodeLayout;
import org.phrenic.engine.force.Springs;

/** Numbers of springs as assembled, and as they are tuned: {@code k f (l - L) + T}. */
final class SpringNumbers {
    final int count;
    /** Ends of each spring, two a spring, caller's numbering. */
    final int[] nodes;
    /** Length of each at rest, mm. */
    final double[] length;
    /** Rest length of each as tuned, mm. */
    final double[] rest;
    /** What full activation takes from each as tuned, mm. */
    final double[] shortening;

    private final Springs springs;
    private final double[] stiffness;
    private final double[] assembledStiffness;
    private final double[] assembledRest;
    private final double[] assembledShortening;

    /**
     * @param positions of all nodes at rest, caller's order, mm
     */
    SpringNumbers(Springs springs, NodeLayout layout, double[] positions) {
        this.springs = springs;
        count = springs.count();
        nodes = springs.callerPairs(layout);
        assembledStiffness = springs.stiffnesses();
        assembledRest = springs.restLengths();
        assembledShortening = springs.shortenings();
        stiffness = assembledStiffness.clone();
        rest = assembledRest.clone();
        shortening = assembledShortening.clone();
        length = new double[count];
        for (int e = 0; e < count; e++) {
            length[e] = SceneParts.distance(positions, nodes[2 * e], positions, nodes[2 * e + 1]);
        }
    }

    /**
     * Makes a spring stiffer without moving where it is at rest.
     *
     * @param factor of its stiffness as assembled
     * @param moreTension beyond its tension at rest as assembled, mN
     */
    void set(int e, double factor, double moreTension) {
        double tension = assembledStiffness[e] * (length[e] - assembledRest[e]) + moreTension;
        stiffness[e] = factor * assembledStiffness[e];
        rest[e] = length[e] - tension / stiffness[e];
    }

    /** Hands all numbers to the springs. */
    void hand() {
        springs.retune(stiffness, rest, shortening);
    }

    /** Gives the springs every number they were assembled with. */
    void asAssembled() {
        springs.retune(assembledStiffness, assembledRest, assembledShortening);
    }
}
