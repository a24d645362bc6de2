package org.phrenic.simulation.observe;

/**
 * Volume swept by a moving surface, ∫ u·n dA: the mean displacement of each triangle times its area vector halfway
 * along the displacement. The error is of third order in the displacement.
 */
final class SweptVolume {
    private SweptVolume() {}

    /**
     * @param t three corners per triangle, anticlockwise seen from the side toward which the volume is positive
     * @param from positions before, mm
     * @param to positions after, mm
     * @return swept volume, mm³; allocates nothing
     */
    static double of(int[] t, double[] from, double[] to) {
        double sum = 0;
        for (int i = 0; i < t.length; i += 3) {
            int a = 3 * t[i];
            int b = 3 * t[i + 1];
            int c = 3 * t[i + 2];
            double ux = (to[a] - from[a] + (to[b] - from[b]) + (to[c] - from[c])) / 3;
            double uy = (to[a + 1] - from[a + 1] + (to[b + 1] - from[b + 1]) + (to[c + 1] - from[c + 1])) / 3;
            double uz = (to[a + 2] - from[a + 2] + (to[b + 2] - from[b + 2]) + (to[c + 2] - from[c + 2])) / 3;
            double x = 0.5 * (to[a] + from[a]);
            double y = 0.5 * (to[a + 1] + from[a + 1]);
            double z = 0.5 * (to[a + 2] + from[a + 2]);
            double px = 0.5 * (to[b] + from[b]) - x;
            double py = 0.5 * (to[b + 1] + from[b + 1]) - y;
            double pz = 0.5 * (to[b + 2] + from[b + 2]) - z;
            double qx = 0.5 * (to[c] + from[c]) - x;
            double qy = 0.5 * (to[c + 1] + from[c + 1]) - y;
            double qz = 0.5 * (to[c + 2] + from[c + 2]) - z;
            sum += 0.5 * (ux * (py * qz - pz * qy) + uy * (pz * qx - px * qz) + uz * (px * qy - py * qx));
        }
        return sum;
    }
}
