package org.phrenic.simulation.observe;

import org.phrenic.mesh.TriangleMesh;

/**
 * Keeps the volume of an organ whose carriers move apart. Where these would make it larger than at rest, it is shrunk
 * about a point within its lower part until it has its volume again:
 *
 * <pre>
 * x' = c + min(1, (V_0 / V)^(1/3)) (x - c)
 * </pre>
 *
 * {@code c} is the mean of the vertices in the lowest {@value #LOWER_SHARE} of its height at rest, so that the organ
 * stays on what it rests on. A convex organ shrunk about a point within lies inside the place that its carriers gave
 * it, and therefore meets nothing that it did not meet there. It is not enlarged where its carriers move together.
 */
final class KeptVolume {
    private static final double LOWER_SHARE = 0.6;

    private final int[] triangles;
    private final boolean[] lower;
    private final int lowerCount;
    private final double restVolume;
    private final double[] centre = new double[3];

    KeptVolume(TriangleMesh rest) {
        triangles = rest.triangles();
        double[] box = rest.bounds();
        double limit = box[2] + LOWER_SHARE * (box[5] - box[2]);
        lower = new boolean[rest.vertexCount()];
        int count = 0;
        for (int v = 0; v < lower.length; v++) {
            lower[v] = rest.z(v) <= limit;
            count += lower[v] ? 1 : 0;
        }
        lowerCount = count;
        double[] p = rest.positions();
        setCentre(p);
        restVolume = volume(p);
    }

    private void setCentre(double[] p) {
        centre[0] = 0;
        centre[1] = 0;
        centre[2] = 0;
        for (int v = 0; v < lower.length; v++) {
            if (lower[v]) {
                for (int axis = 0; axis < 3; axis++) {
                    centre[axis] += p[3 * v + axis] / lowerCount;
                }
            }
        }
    }

    /** Volume about the centre, mm^3. */
    private double volume(double[] p) {
        double sum = 0;
        for (int t = 0; t < triangles.length; t += 3) {
            int a = 3 * triangles[t];
            int b = 3 * triangles[t + 1];
            int c = 3 * triangles[t + 2];
            double bx = p[b] - centre[0];
            double by = p[b + 1] - centre[1];
            double bz = p[b + 2] - centre[2];
            double cx = p[c] - centre[0];
            double cy = p[c + 1] - centre[1];
            double cz = p[c + 2] - centre[2];
            sum += (p[a] - centre[0]) * (by * cz - bz * cy)
                    + (p[a + 1] - centre[1]) * (bz * cx - bx * cz)
                    + (p[a + 2] - centre[2]) * (bx * cy - by * cx);
        }
        return sum / 6;
    }

    /** Shrinks the organ to its volume at rest, in place. Allocates nothing. */
    void apply(double[] p) {
        setCentre(p);
        double now = volume(p);
        // An open piece may be wound inward, and has a negative volume then.
        if (now * restVolume > 0 && Math.abs(now) > Math.abs(restVolume)) {
            double scale = StrictMath.cbrt(restVolume / now);
            for (int i = 0; i < p.length; i++) {
                p[i] = centre[i % 3] + scale * (p[i] - centre[i % 3]);
            }
        }
    }
}
