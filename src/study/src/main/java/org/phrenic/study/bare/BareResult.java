package org.phrenic.study.bare;

/**
 * The result of a bare workload.
 *
 * @param stepsPerSecond median of the timed runs
 * @param min slowest run, steps/s
 * @param max fastest run, steps/s
 * @param nodes particles
 * @param edges springs
 * @param links rigid links
 * @param threads that shared the work
 * @param integrator label of the scheme
 * @param kernel how spring forces are computed
 * @param meanDz200 mean z displacement of the loaded nodes after exactly 200 steps from rest, mm
 * @param roofline what the machine could do at most
 * @param stateSha256 SHA-256 over the bits of all positions, then all velocities, after these 200 steps, in the order
 *     of the mesh's vertices
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

    /** Steps per second as a share of what the machine could do at most. */
    public double fractionOfRoofline() {
        return stepsPerSecond / roofline.stepsPerSecond();
    }
}
