package org.phrenic.patient.registration;

import java.util.Arrays;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Place and size of the body of a vertebra, measured on the vertebra's own surface: rays from inside the body meet its
 * front, its sides, its end plates, and behind it the wall of the vertebral canal.
 *
 * @param centre middle of the body, LPS, mm
 * @param left unit vector to the left of the vertebra
 * @param back unit vector from the front to the spinous process
 * @param up unit vector along the spine
 * @param halfWidthMm half of the distance of its sides
 * @param halfDepthMm half of the distance of its front from the canal
 * @param halfHeightMm half of the distance of its end plates
 */
record VertebralBody(
        double[] centre,
        double[] left,
        double[] back,
        double[] up,
        double halfWidthMm,
        double halfDepthMm,
        double halfHeightMm) {
    /** Vertices this near to the foremost one belong to the body, mm. */
    private static final double FRONT_MM = 10;
    /** Distance of parallel rays, of which the middle one counts, mm. */
    private static final double APART_MM = 3;

    private static final int ROUNDS = 4;
    /** Largest half-axis of a body, mm; a ray that meets nothing nearer counts as this. */
    private static final double LARGEST_MM = 30;

    /**
     * Measures a vertebra.
     *
     * @param left direction to the left of the vertebra
     * @param up direction along the spine; only its part across {@code left} counts
     */
    static VertebralBody of(TriangleTree vertebra, double[] left, double[] up) {
        double[] x = Vectors.normalize(left);
        double[] z = Vectors.orthonormalize(up, x);
        double[] y = Vectors.cross(z, x);
        double[] p = vertebra.mesh().positions();
        double front = Double.POSITIVE_INFINITY;
        for (int v = 0; v < p.length; v += 3) {
            front = Math.min(front, along(p, v, y));
        }
        double[] low = {1e9, 1e9};
        double[] high = {-1e9, -1e9};
        for (int v = 0; v < p.length; v += 3) {
            if (along(p, v, y) < front + FRONT_MM) {
                low[0] = Math.min(low[0], along(p, v, x));
                high[0] = Math.max(high[0], along(p, v, x));
                low[1] = Math.min(low[1], along(p, v, z));
                high[1] = Math.max(high[1], along(p, v, z));
            }
        }
        double[] at = {(low[0] + high[0]) / 2, front + FRONT_MM - 2, (low[1] + high[1]) / 2};
        double[] half = new double[3];
        double[][] axes = {x, y, z};
        for (int round = 0; round < ROUNDS; round++) {
            double[] centre = point(at, axes);
            for (int k = 0; k < 3; k++) {
                double forward = exit(vertebra, centre, axes, k, 1);
                double backward = exit(vertebra, centre, axes, k, -1);
                half[k] = (forward + backward) / 2;
                at[k] += (forward - backward) / 2;
            }
        }
        return new VertebralBody(point(at, axes), x, y, z, half[0], half[1], half[2]);
    }

    private static double[] point(double[] at, double[][] axes) {
        double[] p = new double[3];
        for (int k = 0; k < 3; k++) {
            p = Vectors.addScaled(p, axes[k], at[k]);
        }
        return p;
    }

    private static double along(double[] p, int v, double[] axis) {
        return p[v] * axis[0] + p[v + 1] * axis[1] + p[v + 2] * axis[2];
    }

    /** Median of the distances to the surface along nine parallel rays. */
    private static double exit(TriangleTree tree, double[] from, double[][] axes, int axis, int sign) {
        double[] found = new double[9];
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] d = axes[axis];
        for (int i = 0; i < found.length; i++) {
            double[] start = Vectors.addScaled(from, axes[(axis + 1) % 3], APART_MM * (i % 3 - 1));
            start = Vectors.addScaled(start, axes[(axis + 2) % 3], APART_MM * (i / 3 - 1));
            boolean met =
                    tree.nearestAlongRay(start[0], start[1], start[2], sign * d[0], sign * d[1], sign * d[2], hit);
            found[i] = met ? Math.min(LARGEST_MM, hit.rayParameter) : LARGEST_MM;
        }
        Arrays.sort(found);
        return found[4];
    }

    /** Coordinates of a point to the left, to the back and up from the centre, mm. */
    double[] local(double[] point) {
        double[] d = Vectors.subtract(point, centre);
        return new double[] {Vectors.dot(d, left), Vectors.dot(d, back), Vectors.dot(d, up)};
    }

    /** The point with given coordinates. */
    double[] point(double toLeft, double toBack, double upward) {
        double[] p = Vectors.addScaled(centre, left, toLeft);
        p = Vectors.addScaled(p, back, toBack);
        return Vectors.addScaled(p, up, upward);
    }
}
