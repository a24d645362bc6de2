package org.phrenic.study.error;

import java.util.Arrays;

/**
 * Node positions of a scene during a breath.
 *
 * @param positions one row per sample, every {@link BreathRunner#SAMPLE_S}; three coordinates per node, mm
 * @param substeps substeps per time step required by the stability limit
 * @param cpuS processor time of stepping, s
 * @param wallS elapsed time of stepping, s
 */
record Trajectory(double[][] positions, int substeps, double cpuS, double wallS) {

    /**
     * Distance of selected nodes from another trajectory over all samples: rms, then maximum, mm.
     *
     * @param which marks the selected nodes
     */
    double[] distanceFrom(Trajectory other, boolean[] which) {
        double sum = 0;
        double most = 0;
        long count = 0;
        for (int s = 0; s < positions.length; s++) {
            double[] p = positions[s];
            double[] q = other.positions[s];
            for (int i = 0; i < p.length; i += 3) {
                if (!which[i / 3]) {
                    continue;
                }
                double x = p[i] - q[i];
                double y = p[i + 1] - q[i + 1];
                double z = p[i + 2] - q[i + 2];
                double squared = x * x + y * y + z * z;
                sum += squared;
                // NaN must not pass as a small distance.
                most = squared <= most ? most : squared;
                count++;
            }
        }
        return new double[] {Math.sqrt(sum / count), Math.sqrt(most)};
    }

    /** The first part of the trajectory, to the last sample at a time. */
    Trajectory until(double timeS) {
        int samples = Math.min(positions.length, Math.max(1, (int) Math.round(timeS / BreathRunner.SAMPLE_S)));
        return new Trajectory(Arrays.copyOf(positions, samples), substeps, cpuS, wallS);
    }

    /** Richardson extrapolation of a scheme of order 1 from two steps, the second half as long as the first. */
    static Trajectory extrapolated(Trajectory coarse, Trajectory fine) {
        double[][] positions = new double[fine.positions.length][];
        for (int s = 0; s < positions.length; s++) {
            double[] p = fine.positions[s].clone();
            for (int i = 0; i < p.length; i++) {
                p[i] += p[i] - coarse.positions[s][i];
            }
            positions[s] = p;
        }
        return new Trajectory(positions, fine.substeps, coarse.cpuS + fine.cpuS, coarse.wallS + fine.wallS);
    }

    /** Distance of all nodes from another trajectory over all samples: rms, then maximum, mm. */
    double[] distanceFrom(Trajectory other) {
        boolean[] all = new boolean[positions[0].length / 3];
        Arrays.fill(all, true);
        return distanceFrom(other, all);
    }
}
