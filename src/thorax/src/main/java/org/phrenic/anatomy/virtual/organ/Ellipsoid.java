package org.phrenic.anatomy.virtual.organ;

import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;

/**
 * A rotated ellipsoid. The value is {@code k0 (k0 - 1) / k1} with {@code k0 = |q / r|} and {@code k1 = |q / r²|} for a
 * point q in the axes of the ellipsoid: exact on the surface, where its gradient has length 1.
 */
final class Ellipsoid implements ImplicitSurface {
    private final double[] centre;
    private final double[] half;
    /** Rows are the axes of the ellipsoid. */
    private final double[] axes = new double[9];

    private final double reach;

    /** @param row x, y, z, three half-axes, and rotations about x, then y, then z, degrees */
    Ellipsoid(ImmutableDoubleArray row) {
        centre = new double[] {row.at(0), row.at(1), row.at(2)};
        half = new double[] {row.at(3), row.at(4), row.at(5)};
        reach = Math.max(half[0], Math.max(half[1], half[2]));
        for (int axis = 0; axis < 3; axis++) {
            double[] v = new double[3];
            v[axis] = 1;
            for (int about = 0; about < 3; about++) {
                rotate(v, about, StrictMath.toRadians(row.at(6 + about)));
            }
            System.arraycopy(v, 0, axes, 3 * axis, 3);
        }
    }

    private static void rotate(double[] v, int about, double angle) {
        int i = (about + 1) % 3;
        int j = (about + 2) % 3;
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double a = v[i];
        v[i] = cos * a - sin * v[j];
        v[j] = sin * a + cos * v[j];
    }

    @Override
    public double at(double x, double y, double z) {
        double dx = x - centre[0];
        double dy = y - centre[1];
        double dz = z - centre[2];
        double k0 = 0;
        double k1 = 0;
        for (int axis = 0; axis < 3; axis++) {
            double q = (axes[3 * axis] * dx + axes[3 * axis + 1] * dy + axes[3 * axis + 2] * dz) / half[axis];
            k0 += q * q;
            k1 += q * q / (half[axis] * half[axis]);
        }
        k0 = Math.sqrt(k0);
        return k1 < 1e-18 ? -Math.min(half[0], Math.min(half[1], half[2])) : k0 * (k0 - 1) / Math.sqrt(k1);
    }

    /** Extends a box, low corner and high corner, by this ellipsoid in any rotation. */
    void extend(double[] box) {
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = Math.min(box[axis], centre[axis] - reach);
            box[3 + axis] = Math.max(box[3 + axis], centre[axis] + reach);
        }
    }
}
