package org.phrenic.access.imaging;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Weighted lengths of the rays of a {@link CArm} inside closed surfaces: {@code sum_s w_s L_s} for every pixel.
 *
 * <p>The length inside a closed, outward oriented surface is the sum of the signed distances from the source at which
 * the ray crosses it, minus at an entry, plus at an exit. Triangles are scan-converted in perspective. A pixel that an
 * edge passes belongs to one of the two triangles of that edge and no pixel to both, because the crossing of an edge
 * with a row is computed from the edge alone, so the lengths are exact up to rounding for any closed surface, self-
 * intersecting ones included (a part covered twice counts twice). The sums do not depend on the number of threads.
 */
final class PathLengths {
    private final CArm arm;
    private final double[] source;
    private final double[] sums;
    private final int threads;

    /** @param threads number of bands of rows that are computed concurrently */
    PathLengths(CArm arm, int threads) {
        this.arm = arm;
        this.threads = Math.max(1, Math.min(threads, arm.rows()));
        source = arm.source();
        sums = new double[arm.columns() * arm.rows()];
    }

    /**
     * A surface as the source sees it.
     *
     * @param triangles those that rays of the detector may meet
     * @param depths distances before the plane of the source, in units of that of the detector
     */
    private record Projected(TriangleMesh mesh, int[] triangles, double[] columns, double[] rows, double[] depths) {}

    /**
     * Adds the lengths inside a surface.
     *
     * @param mesh closed, oriented outward, LPS, mm; what rays of the detector meet lies in front of the source
     * @param weight factor of the lengths, such as an attenuation coefficient
     * @throws BadInputException if the source is inside the surface, or a triangle behind it may be met
     */
    void add(TriangleMesh mesh, double weight) {
        Projected seen = project(mesh);
        int band = (arm.rows() + threads - 1) / threads;
        IntStream bands = IntStream.range(0, threads);
        (threads > 1 ? bands.parallel() : bands).forEach(i -> {
            Band rows = new Band(i * band, Math.min(arm.rows(), (i + 1) * band));
            for (int t = 0; t < seen.triangles.length; t += 3) {
                rows.add(seen, t, weight);
            }
        });
    }

    private Projected project(TriangleMesh mesh) {
        int n = mesh.vertexCount();
        double[] columns = new double[n];
        double[] rows = new double[n];
        double[] depths = new double[n];
        double[] axis = arm.axis();
        double[] right = arm.right();
        double[] up = arm.up();
        boolean inFront = true;
        for (int v = 0; v < n; v++) {
            double x = mesh.x(v) - source[0];
            double y = mesh.y(v) - source[1];
            double z = mesh.z(v) - source[2];
            double depth = x * axis[0] + y * axis[1] + z * axis[2];
            inFront &= depth > 0;
            depths[v] = depth / arm.sourceDetectorMm();
            double scale = arm.sourceDetectorMm() / depth / arm.pixelMm();
            columns[v] = (arm.columns() - 1) / 2.0 + scale * (x * right[0] + y * right[1] + z * right[2]);
            rows[v] = (arm.rows() - 1) / 2.0 - scale * (x * up[0] + y * up[1] + z * up[2]);
        }
        int[] triangles = inFront ? mesh.triangles() : met(mesh, depths);
        return new Projected(mesh, triangles, columns, rows, depths);
    }

    /** Triangles of a surface that reaches behind the source, without those that no ray of the detector meets. */
    private int[] met(TriangleMesh mesh, double[] depths) {
        if (Arrays.stream(depths).allMatch(depth -> depth <= 0)) {
            return new int[0];
        }
        if (isInBox(mesh.bounds()) && new TriangleTree(mesh).isInside(source[0], source[1], source[2])) {
            throw refusal();
        }
        IntList met = new IntList();
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i += 3) {
            boolean inFront = depths[t[i]] > 0 && depths[t[i + 1]] > 0 && depths[t[i + 2]] > 0;
            boolean behind = depths[t[i]] <= 0 && depths[t[i + 1]] <= 0 && depths[t[i + 2]] <= 0;
            if (inFront) {
                met.add(t[i]);
                met.add(t[i + 1]);
                met.add(t[i + 2]);
            } else if (!behind && !isBeside(mesh, t[i], t[i + 1], t[i + 2])) {
                throw refusal();
            }
        }
        return met.toArray();
    }

    private boolean isInBox(double[] bounds) {
        return IntStream.range(0, 3).allMatch(i -> source[i] >= bounds[i] && source[i] <= bounds[3 + i]);
    }

    private BadInputException refusal() {
        return new BadInputException(Numbers.format(
                "C-arm at %.3f/%.3f (LAO/cranial): found the source inside the body or beside it, expected it outside",
                arm.leftObliqueDeg(), arm.cranialDeg()));
    }

    /** Whether a triangle lies beyond one of the four planes through the source and the borders of the detector. */
    private boolean isBeside(TriangleMesh mesh, int... corners) {
        double width = 0.5 * arm.pixelMm() * arm.columns() / arm.sourceDetectorMm();
        double height = 0.5 * arm.pixelMm() * arm.rows() / arm.sourceDetectorMm();
        double[] aside = Vectors.addScaled(new double[3], arm.axis(), -width);
        double[] above = Vectors.addScaled(new double[3], arm.axis(), -height);
        return Stream.of(
                        Vectors.addScaled(aside, arm.right(), 1),
                        Vectors.addScaled(aside, arm.right(), -1),
                        Vectors.addScaled(above, arm.up(), 1),
                        Vectors.addScaled(above, arm.up(), -1))
                .anyMatch(outward -> IntStream.of(corners)
                        .allMatch(v -> Vectors.dot(
                                        outward,
                                        Vectors.of(mesh.x(v) - source[0], mesh.y(v) - source[1], mesh.z(v) - source[2]))
                                > 0));
    }

    /** Rows of the image that one thread computes. */
    private final class Band {
        private final int first;
        private final int end;
        private final double[] origin = arm.ray(0, 0);
        private final double[] perColumn = Vectors.subtract(arm.ray(1, 0), origin);
        private final double[] perRow = Vectors.subtract(arm.ray(0, 1), origin);

        Band(int first, int end) {
            this.first = first;
            this.end = end;
        }

        void add(Projected seen, int triangle, double weight) {
            int[] t = seen.triangles;
            int a = t[triangle];
            int b = t[triangle + 1];
            int c = t[triangle + 2];
            double ya = seen.rows[a];
            double yb = seen.rows[b];
            double yc = seen.rows[c];
            int from = Math.max(first, (int) Math.ceil(Math.min(ya, Math.min(yb, yc))));
            int to = Math.min(end, (int) Math.ceil(Math.max(ya, Math.max(yb, yc))));
            if (from >= to) {
                return;
            }
            Plane plane = new Plane(seen, a, b, c);
            for (int row = from; row < to; row++) {
                int entry = 0;
                int exit = 0;
                // A closed loop of edges crosses a row once upward and once downward.
                int ab = direction(ya, yb, row);
                int bc = direction(yb, yc, row);
                int ca = direction(yc, ya, row);
                if (ab != 0) {
                    int at = crossing(seen, a, b, row);
                    entry = ab > 0 ? at : entry;
                    exit = ab < 0 ? at : exit;
                }
                if (bc != 0) {
                    int at = crossing(seen, b, c, row);
                    entry = bc > 0 ? at : entry;
                    exit = bc < 0 ? at : exit;
                }
                if (ca != 0) {
                    int at = crossing(seen, c, a, row);
                    entry = ca > 0 ? at : entry;
                    exit = ca < 0 ? at : exit;
                }
                plane.fill(row, entry, exit, weight);
            }
        }

        /**
         * +1 if an edge passes a row downward in the image, -1 upward, 0 if it does not; its upper end is part of it.
         */
        private static int direction(double from, double to, int row) {
            if (from <= row) {
                return to > row ? 1 : 0;
            }
            return to <= row ? -1 : 0;
        }

        /** First column at or after the crossing of an edge with a row; the same from both triangles of the edge. */
        private static int crossing(Projected seen, int one, int other, int row) {
            int low = Math.min(one, other);
            int high = Math.max(one, other);
            double slope = (seen.columns[high] - seen.columns[low]) / (seen.rows[high] - seen.rows[low]);
            return (int) Math.ceil(seen.columns[low] + (row - seen.rows[low]) * slope);
        }

        /**
         * The plane of a triangle: {@code t = offset / (normal . ray)} in units of the ray from source to pixel. It is
         * kept between those of the vertices, so that a triangle seen edge-on gives no more than rounding.
         */
        private final class Plane {
            private final double offset;
            private final double start;
            private final double column;
            private final double step;
            private final double nearest;
            private final double farthest;

            Plane(Projected seen, int a, int b, int c) {
                TriangleMesh mesh = seen.mesh;
                nearest = Math.min(seen.depths[a], Math.min(seen.depths[b], seen.depths[c]));
                farthest = Math.max(seen.depths[a], Math.max(seen.depths[b], seen.depths[c]));
                double[] from = {mesh.x(a) - source[0], mesh.y(a) - source[1], mesh.z(a) - source[2]};
                double[] ab = {mesh.x(b) - mesh.x(a), mesh.y(b) - mesh.y(a), mesh.z(b) - mesh.z(a)};
                double[] ac = {mesh.x(c) - mesh.x(a), mesh.y(c) - mesh.y(a), mesh.z(c) - mesh.z(a)};
                double[] normal = Vectors.cross(ab, ac);
                offset = Vectors.dot(normal, from);
                start = Vectors.dot(normal, origin);
                column = Vectors.dot(normal, perColumn);
                step = Vectors.dot(normal, perRow);
            }

            /** Adds the signed distances of a row between two crossings. */
            void fill(int row, int entry, int exit, double weight) {
                int from = Math.max(0, Math.min(entry, exit));
                int to = Math.min(arm.columns(), Math.max(entry, exit));
                double signed = entry < exit ? weight : -weight;
                double base = start + row * step;
                int at = row * arm.columns();
                for (int x = from; x < to; x++) {
                    double t = offset / (base + x * column);
                    sums[at + x] += signed * (t > nearest ? Math.min(t, farthest) : nearest);
                }
            }
        }
    }

    /** The sums, row by row; units of the weights times mm. */
    double[] values() {
        double[] values = Arrays.copyOf(sums, sums.length);
        for (int row = 0; row < arm.rows(); row++) {
            for (int column = 0; column < arm.columns(); column++) {
                values[row * arm.columns() + column] *= Vectors.length(arm.ray(column, row));
            }
        }
        return values;
    }
}
