package org.phrenic.patient.registration;

import java.util.stream.IntStream;

/**
 * A smooth displacement field fitted to point pairs. The field at x is the weighted mean of the displacements of all
 * points within the radius r. The weights are {@code w = (1 - d^2 / r^2)^2}, where d is the distance from x. The field
 * decays to zero where no point is near:
 *
 * <pre>
 * u(x) = sum w (to - from) / (sum w + a),   a = 0.3
 * </pre>
 *
 * The field is evaluated on a grid with a spacing of one third of the radius. Between nodes it is interpolated
 * trilinearly.
 */
final class DisplacementField implements PointTransform {
    private static final double ATTENUATION = 0.3;
    private static final double CELLS_PER_RADIUS = 3;

    private final double[] origin = new double[3];
    private final int[] size = new int[3];
    private final double spacing;
    private final double[] shift;

    /**
     * @param from source points as x, y, z triples, mm
     * @param to target points in the same order
     * @param bounds bounding box of the points to transform: {@code {minX, minY, minZ, maxX, maxY, maxZ}}
     */
    DisplacementField(double[] from, double[] to, double radius, double[] bounds) {
        spacing = radius / CELLS_PER_RADIUS;
        int nodes = 1;
        for (int k = 0; k < 3; k++) {
            origin[k] = bounds[k] - spacing;
            size[k] = (int) Math.ceil((bounds[3 + k] - bounds[k]) / spacing) + 3;
            nodes *= size[k];
        }
        shift = new double[3 * nodes];
        double[] weights = new double[nodes];
        // Each layer adds the points in order, so the result is bit-identical for any number of threads.
        IntStream.range(0, size[2]).parallel().forEach(c -> layer(c, from, to, radius, weights));
    }

    private void layer(int c, double[] from, double[] to, double radius, double[] weights) {
        for (int i = 0; i < from.length; i += 3) {
            if (c >= low(from, i, 2, radius) && c <= high(from, i, 2, radius)) {
                add(c, from, to, i, radius, weights);
            }
        }
        int layer = size[0] * size[1];
        for (int n = c * layer; n < (c + 1) * layer; n++) {
            for (int k = 0; k < 3; k++) {
                shift[3 * n + k] /= weights[n] + ATTENUATION;
            }
        }
    }

    /** Index of the first grid node along an axis within the radius of a point. */
    private int low(double[] from, int i, int axis, double radius) {
        return Math.max(0, (int) Math.ceil((from[i + axis] - radius - origin[axis]) / spacing));
    }

    private int high(double[] from, int i, int axis, double radius) {
        return Math.min(size[axis] - 1, (int) Math.floor((from[i + axis] + radius - origin[axis]) / spacing));
    }

    private void add(int c, double[] from, double[] to, int i, double radius, double[] weights) {
        double dz = origin[2] + c * spacing - from[i + 2];
        int lowA = low(from, i, 0, radius);
        int highA = high(from, i, 0, radius);
        int highB = high(from, i, 1, radius);
        for (int b = low(from, i, 1, radius); b <= highB; b++) {
            double dy = origin[1] + b * spacing - from[i + 1];
            for (int a = lowA; a <= highA; a++) {
                double dx = origin[0] + a * spacing - from[i];
                double rest = 1 - (dx * dx + dy * dy + dz * dz) / (radius * radius);
                if (rest > 0) {
                    int n = a + size[0] * (b + size[1] * c);
                    weights[n] += rest * rest;
                    for (int k = 0; k < 3; k++) {
                        shift[3 * n + k] += rest * rest * (to[i + k] - from[i + k]);
                    }
                }
            }
        }
    }

    @Override
    public void apply(double[] points) {
        int[] cell = new int[3];
        int[] node = new int[3];
        double[] part = new double[3];
        for (int i = 0; i < points.length; i += 3) {
            for (int k = 0; k < 3; k++) {
                double at = (points[i + k] - origin[k]) / spacing;
                cell[k] = Math.max(0, Math.min(size[k] - 2, (int) Math.floor(at)));
                part[k] = Math.max(0, Math.min(1, at - cell[k]));
            }
            for (int corner = 0; corner < 8; corner++) {
                double weight = 1;
                for (int k = 0; k < 3; k++) {
                    int bit = corner >> k & 1;
                    node[k] = cell[k] + bit;
                    weight *= bit == 1 ? part[k] : 1 - part[k];
                }
                int n = 3 * (node[0] + size[0] * (node[1] + size[1] * node[2]));
                points[i] += weight * shift[n];
                points[i + 1] += weight * shift[n + 1];
                points[i + 2] += weight * shift[n + 2];
            }
        }
    }
}
