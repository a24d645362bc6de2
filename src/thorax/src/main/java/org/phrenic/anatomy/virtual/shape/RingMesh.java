package org.phrenic.anatomy.virtual.shape;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleToIntFunction;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;

/**
 * Triangle mesh over {@link Meridians}: concentric rings about the pole, joined by strips of triangles. The number of
 * points of a ring is proportional to its perimeter. The last ring is the border; its vertices come last.
 */
public final class RingMesh {
    private RingMesh() {}

    /** Number of points on each ring, from the pole outward without the pole, for edges of about {@code edge} mm. */
    public static int[] counts(Meridians meridians, double edge, int border) {
        int rings = Math.max(3, (int) Math.round(meridians.meanLength() / (edge * 0.88)));
        int[] counts = new int[rings];
        double[] perimeters = meridians.perimeters(rings);
        Arrays.setAll(counts, k -> Math.max(6, (int) Math.round(perimeters[k] / edge)));
        counts[rings - 1] = border > 0 ? border : counts[rings - 1];
        return counts;
    }

    public static int vertexCount(int[] counts) {
        return 1 + Arrays.stream(counts).sum();
    }

    /** Edge length at which {@code count(edge)}, a decreasing function, is closest to {@code target}. */
    public static double edgeLengthFor(DoubleToIntFunction count, int target) {
        double best = 6;
        int bestMiss = Integer.MAX_VALUE;
        double low = 1.5;
        double high = 30;
        for (int i = 0; i < 40; i++) {
            double middle = Math.sqrt(low * high);
            int n = count.applyAsInt(middle);
            if (n == target) {
                return middle;
            }
            if (Math.abs(n - target) < bestMiss) {
                bestMiss = Math.abs(n - target);
                best = middle;
            }
            if (n > target) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return best;
    }

    /** Builds the mesh. If {@code upward}, triangles are counterclockwise seen from above. */
    public static TriangleMesh mesh(Meridians meridians, int[] counts, boolean upward) {
        double[] positions = new double[3 * vertexCount(counts)];
        System.arraycopy(meridians.pole(), 0, positions, 0, 3);
        List<int[]> triangles = new ArrayList<>();
        int from = 0;
        int inner = 1;
        for (int k = 0; k < counts.length; k++) {
            double[][] ring = meridians.ring((k + 1.0) / counts.length);
            int start = from + inner;
            placeEvenly(ring, counts[k], positions, start);
            if (k == 0) {
                for (int i = 0; i < counts[0]; i++) {
                    triangles.add(new int[] {0, start + (i + 1) % counts[0], start + i});
                }
            } else {
                stitchRings(from, inner, start, counts[k], triangles);
            }
            from = start;
            inner = counts[k];
        }
        int[] flat = new int[3 * triangles.size()];
        for (int t = 0; t < triangles.size(); t++) {
            int[] triangle = triangles.get(t);
            flat[3 * t] = triangle[0];
            flat[3 * t + 1] = triangle[upward ? 1 : 2];
            flat[3 * t + 2] = triangle[upward ? 2 : 1];
        }
        return new TriangleMesh(positions, flat);
    }

    /** Places points at equal spacing along a closed line, the first at azimuth 0. */
    private static void placeEvenly(double[][] ring, int count, double[] positions, int start) {
        List<double[]> closed = new ArrayList<>(List.of(ring));
        closed.add(ring[0]);
        Polyline course = new Polyline(closed);
        for (int i = 0; i < count; i++) {
            System.arraycopy(course.pointAt(course.length() * i / count), 0, positions, 3 * (start + i), 3);
        }
    }

    private static void stitchRings(int a, int countA, int b, int countB, List<int[]> triangles) {
        int i = 0;
        int j = 0;
        while (i < countA || j < countB) {
            boolean stepB = i == countA || (j < countB && (j + 0.5) / countB <= (i + 0.5) / countA);
            if (stepB) {
                triangles.add(new int[] {a + i % countA, b + (j + 1) % countB, b + j % countB});
                j++;
            } else {
                triangles.add(new int[] {a + i % countA, a + (i + 1) % countA, b + j % countB});
                i++;
            }
        }
    }
}
