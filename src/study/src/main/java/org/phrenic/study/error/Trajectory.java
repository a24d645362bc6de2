package org.phrenic.study.error;

import java.util.Arrays;

/**
 * Positions of the nodes of a scene during a breath.
 *
 * @param positions a row a sample, every {@link BreathRunner#SAMPLE_S}, three numbers a node, mm
 * @param substeps into which the stability limit split a step
 * @param cpuS time that processors spent stepping, s
 * @param wallS time that stepping took, s
 */
record Trajectory(double[][] positions, int substeps, double cpuS, double wallS) {

    /**
     * Distance of some nodes from where another trajectory has them, over all samples: root of the mean square, then
     * the greatest, mm.
     *
     * @param which for each node whether it counts
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
                // NaN must not count as small.
                most = squared <= most ? most : squared;
                count++;
            }
        }
        return new double[] {Math.sqrt(sum / count), Math.sqrt(most)};
    }

    /**
     * Distance of all nodes from where another trajectory has them, over all samples: root of the mean square, then the
     * greatest, mm.
     */
    double[] distanceFrom(Trajectory other) {
        boolean[] all = new boolean[positions[0].length / 3];
        Arrays.fill(all, true);
        return distanceFrom(other, all);
    }
}
