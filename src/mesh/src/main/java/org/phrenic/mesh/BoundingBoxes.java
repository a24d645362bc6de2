package org.phrenic.mesh;

import java.util.Arrays;
import java.util.stream.Stream;

/**
 * Axis-aligned bounding boxes, six numbers each in a longer array: minimum x, y, z, then maximum x, y, z, mm.
 * Comparisons are written out because Math.min and Math.max, which order signed zeros, are slow until compiled.
 */
public final class BoundingBoxes {
    private BoundingBoxes() {}

    /** Sets a box to the empty box. */
    public static void setEmpty(double[] boxes, int at) {
        Arrays.fill(boxes, at, at + 3, Double.POSITIVE_INFINITY);
        Arrays.fill(boxes, at + 3, at + 6, Double.NEGATIVE_INFINITY);
    }

    /** Extends a box to contain a point of another array. */
    public static void include(double[] boxes, int at, double[] points, int point) {
        for (int axis = 0; axis < 3; axis++) {
            double value = points[point + axis];
            if (value < boxes[at + axis]) {
                boxes[at + axis] = value;
            }
            if (value > boxes[at + 3 + axis]) {
                boxes[at + 3 + axis] = value;
            }
        }
    }

    /**
     * Sets a box to that of consecutive points, three numbers each, from {@code from} to before {@code to}; the bounds
     * stay in registers, which is why one axis follows the other.
     */
    public static void around(double[] points, int from, int to, double[] boxes, int at) {
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = from + axis; i < to; i += 3) {
                double value = points[i];
                low = value < low ? value : low;
                high = value > high ? value : high;
            }
            boxes[at + axis] = low;
            boxes[at + 3 + axis] = high;
        }
    }

    /** Box of meshes; empty, with minimum greater than maximum, without any. */
    public static double[] of(Stream<TriangleMesh> meshes) {
        double[] box = new double[6];
        setEmpty(box, 0);
        meshes.map(TriangleMesh::bounds).forEach(one -> {
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = Math.min(box[axis], one[axis]);
                box[3 + axis] = Math.max(box[3 + axis], one[3 + axis]);
            }
        });
        return box;
    }

    /** Squared distance of a point from a box; 0 inside. */
    public static double squaredDistance(double[] boxes, int at, double x, double y, double z) {
        double dx = twiceOutside(boxes[at] - x, x - boxes[at + 3]);
        double dy = twiceOutside(boxes[at + 1] - y, y - boxes[at + 4]);
        double dz = twiceOutside(boxes[at + 2] - z, z - boxes[at + 5]);
        return 0.25 * (dx * dx + dy * dy + dz * dz);
    }

    /** Twice the sum of the positive ones of two numbers, without a branch, which would be predicted badly. */
    private static double twiceOutside(double below, double above) {
        return below + Math.abs(below) + (above + Math.abs(above));
    }

    /**
     * Whether a ray intersects a box (slab method).
     *
     * @param limit greatest ray parameter, in lengths of the direction
     * @param padding margin added to the box on all sides, mm
     * @param relative tolerance of the comparison, relative to the ray parameter, in addition to {@code padding}
     */
    public static boolean meetsRay(
            double[] boxes,
            int at,
            double[] origin,
            double[] direction,
            double limit,
            double padding,
            double relative) {
        double near = 0;
        double far = limit;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes[at + axis] - padding - origin[axis];
            double high = boxes[at + 3 + axis] + padding - origin[axis];
            double along = direction[axis];
            if (along == 0) {
                if (low > 0 || high < 0) {
                    return false;
                }
                continue;
            }
            double t1 = low / along;
            double t2 = high / along;
            near = Math.max(near, Math.min(t1, t2));
            far = Math.min(far, Math.max(t1, t2));
        }
        return near <= far + (padding + relative * Math.abs(far));
    }
}
