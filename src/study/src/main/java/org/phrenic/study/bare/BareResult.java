package org.phrenic.study.bare;

/**
 * Result of the bare workload.
 *
 * @param stepsPerSecond median of the timed runs, steps/s
 * @param min slowest run, steps/s
 * @param max fastest run, steps/s
 * @param nodes number of particles
 * @param edges number of springs
 * @param links number of rigid links
 * @param threads number of worker threads
 * @param integrator label of the scheme
 * @param kernel label of the spring force kernel
 * @param meanDz200 mean z displacement of the loaded nodes after exactly 200 steps from rest, mm
 * @param roofline upper bound for the machine
 * @param stateSha256 SHA-256 over the bits of all positions, then all velocities, after these 200 steps, in vertex
 *     order
 */
public record BareResult(
        double stepsPerSecond,
        double min,
        double max,
        int nodes,
        int edges,
        int links,
        int threads,
        String integrator,
        String kernel,
        double meanDz200,
        Roofline roofline,
        String stateSha256) {

    /** Steps per second as a fraction of the machine's upper bound. */
    public double fractionOfRoofline() {
        return stepsPerSecond / roofline.stepsPerSecond();
    }
}
