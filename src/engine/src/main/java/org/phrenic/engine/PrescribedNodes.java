package org.phrenic.engine;

/** The nodes of a system with prescribed motion, and that motion. */
final class PrescribedNodes {
    private int[] node = {};
    private PrescribedMotion motion = PrescribedMotion.stationary(new double[0]);
    private double[] givenX = {};
    private double[] givenV = {};
    private boolean stationaryApplied;

    /** Internal numbers of the nodes. */
    int[] nodes() {
        return node;
    }

    /**
     * Replaces nodes and motion.
     *
     * @param internalNodes each once
     * @param positions their motion in the same order
     * @throws IllegalArgumentException if the numbers of nodes and points differ
     */
    void prescribe(int[] internalNodes, PrescribedMotion positions) {
        if (internalNodes.length != positions.pointCount()) {
            throw new IllegalArgumentException("found " + internalNodes.length + " nodes and " + positions.pointCount()
                    + " prescribed points, expected as many");
        }
        motion = positions;
        node = internalNodes;
        givenX = new double[3 * internalNodes.length];
        givenV = new double[3 * internalNodes.length];
        stationaryApplied = false;
    }

    /**
     * Call it after the state was changed from outside: stationary nodes are placed again at the next {@code apply}.
     */
    void invalidate() {
        stationaryApplied = false;
    }

    void saveMotion() {
        motion.saveMotion();
    }

    void restoreMotion() {
        motion.restoreMotion();
    }

    /**
     * Sets the nodes to their positions and velocities at a time.
     *
     * @param ofSystem whether the arrays are the system's own state, in which stationary nodes are placed only once
     */
    void apply(double time, double[] position, double[] velocity, boolean ofSystem) {
        if (node.length == 0 || (stationaryApplied && ofSystem)) {
            return;
        }
        motion.at(time, givenX, givenV);
        for (int i = 0; i < node.length; i++) {
            int at = 3 * node[i];
            int from = 3 * i;
            position[at] = givenX[from];
            position[at + 1] = givenX[from + 1];
            position[at + 2] = givenX[from + 2];
            velocity[at] = givenV[from];
            velocity[at + 1] = givenV[from + 1];
            velocity[at + 2] = givenV[from + 2];
        }
        // Nothing moves a stationary node without inverse mass, so it need not be placed in every step.
        stationaryApplied = motion.isStationary() && ofSystem;
    }
}
