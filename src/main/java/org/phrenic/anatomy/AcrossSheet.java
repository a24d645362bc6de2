package org.phrenic.anatomy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.TriangleMesh;

/**
 * Pairs of vertices across the thickness of the sheet, by the rule of Villard, Bourne and Bello 2009: take the masses within a suitable distance, discard by an angle test
 * those on the same face, sort what remains on the opposing face by distance.
 */
public final class AcrossSheet {
    /** Normals of two faces of a sheet point apart: a neighbour on the same face has a positive product. */
    private static final double OPPOSING = -0.25;
    /** What lies closer is a seam between patches, not the other face. */
    private static final double SHORTEST_MM = 0.2;

    /** Vertices that one thread takes at a time. */
    private static final int RUN = 256;

    private final TriangleMesh sheet;
    private final int[][] opposing;

    /** One pair of vertices. */
    public record Pair(int a, int b) {}

    /**
     * Across the thickness of the diaphragm.
     *
     * @param diaphragm whose faces are told apart
     * @param reach the suitable distance, mm
     */
    public static AcrossSheet of(Diaphragm diaphragm, double reach) {
        return new AcrossSheet(diaphragm.sheet(), reach, (i, j) -> diaphragm.isThoracic(i) != diaphragm.isThoracic(j));
    }

    /**
     * Across any closed body that is thin in one direction at least (a cartilage, a sternum), told by normals alone.
     *
     * @param body closed surface
     * @param reach the suitable distance, mm
     */
    public static AcrossSheet of(TriangleMesh body, double reach) {
        return new AcrossSheet(body, reach, (i, j) -> true);
    }

    private interface Opposite {
        boolean test(int i, int j);
    }

    private AcrossSheet(TriangleMesh sheet, double reach, Opposite opposite) {
        this.sheet = sheet;
        double[] normals = MeshMeasure.vertexNormals(sheet);
        PointGrid grid = new PointGrid(sheet.positions(), reach);
        opposing = new int[sheet.vertexCount()][];
        // Each vertex is found by itself, so it does not matter who does which.
        IntStream.range(0, (opposing.length + RUN - 1) / RUN).parallel().forEach(run -> {
            long[] found = new long[64];
            int end = Math.min(opposing.length, (run + 1) * RUN);
            for (int i = run * RUN; i < end; i++) {
                found = across(grid, normals, i, reach, opposite, found);
            }
        });
    }

    private long[] across(PointGrid grid, double[] normals, int i, double reach, Opposite opposite, long[] room) {
        long[] found = room;
        int count = 0;
        double[] p = sheet.positions();
        double x = p[3 * i];
        double y = p[3 * i + 1];
        double z = p[3 * i + 2];
        double most = reach * reach;
        for (int row = 0; row < 9; row++) {
            int end = grid.rowEnd(i, row);
            for (int k = grid.rowStart(i, row); k < end; k++) {
                int j = grid.point(k);
                double dx = p[3 * j] - x;
                double dy = p[3 * j + 1] - y;
                double dz = p[3 * j + 2] - z;
                double square = dx * dx + dy * dy + dz * dz;
                if (square <= most
                        && square > SHORTEST_MM * SHORTEST_MM
                        && dot(normals, i, j) < OPPOSING
                        && opposite.test(i, j)) {
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count);
                    }
                    found[count++] = byDistance(Math.sqrt(square), j);
                }
            }
        }
        Arrays.sort(found, 0, count);
        opposing[i] = new int[count];
        for (int k = 0; k < count; k++) {
            opposing[i][k] = (int) found[k];
        }
        return found;
    }

    /** A number that sorts by distance, then by index. */
    private static long byDistance(double distance, int index) {
        return (long) Float.floatToIntBits((float) distance) << 32 | index;
    }

    private static double distance(TriangleMesh m, int i, int j) {
        double x = m.x(i) - m.x(j);
        double y = m.y(i) - m.y(j);
        double z = m.z(i) - m.z(j);
        return Math.sqrt(x * x + y * y + z * z);
    }

    private static double dot(double[] v, int i, int j) {
        return v[3 * i] * v[3 * j] + v[3 * i + 1] * v[3 * j + 1] + v[3 * i + 2] * v[3 * j + 2];
    }

    /** Each vertex with its nearest opposing ones, at most so many a vertex; each pair once. */
    public List<Pair> nearest(int most) {
        long[] keys = new long[most * opposing.length];
        int count = 0;
        for (int i = 0; i < opposing.length; i++) {
            for (int k = 0; k < Math.min(most, opposing[i].length); k++) {
                int j = opposing[i][k];
                keys[count++] = (long) Math.min(i, j) << 32 | Math.max(i, j);
            }
        }
        return Arrays.stream(keys, 0, count)
                .sorted()
                .distinct()
                .mapToObj(k -> new Pair((int) (k >> 32), (int) k))
                .toList();
    }

    /**
     * Pairs between chosen vertices, shortest first, a vertex in at most so many of them. As rigid links of the tendon: with one a vertex a single pass puts
     * all of them right exactly.
     */
    public List<Pair> matched(IntPredicate chosen, int mostPerVertex) {
        int[] first = new int[256];
        int[] second = new int[256];
        long[] order = new long[256];
        int count = 0;
        for (int i = 0; i < opposing.length; i++) {
            if (!chosen.test(i)) {
                continue;
            }
            for (int j : opposing[i]) {
                if (i < j && chosen.test(j)) {
                    if (count == order.length) {
                        first = Arrays.copyOf(first, 2 * count);
                        second = Arrays.copyOf(second, 2 * count);
                        order = Arrays.copyOf(order, 2 * count);
                    }
                    first[count] = i;
                    second[count] = j;
                    order[count] = byDistance(distance(sheet, i, j), count);
                    count++;
                }
            }
        }
        Arrays.sort(order, 0, count);
        int[] used = new int[opposing.length];
        List<Pair> links = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            Pair p = new Pair(first[(int) order[k]], second[(int) order[k]]);
            if (used[p.a] < mostPerVertex && used[p.b] < mostPerVertex) {
                used[p.a]++;
                used[p.b]++;
                links.add(p);
            }
        }
        return links;
    }

    /** Share of vertices that have an opposing one in reach. */
    public double coverage() {
        return Arrays.stream(opposing).filter(o -> o.length > 0).count() / (double) opposing.length;
    }
}
