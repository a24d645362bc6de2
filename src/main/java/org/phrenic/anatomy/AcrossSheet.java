package org.phrenic.anatomy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.IntPredicate;
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
        int n = sheet.vertexCount();
        Map<Long, List<Integer>> grid = new HashMap<>();
        for (int i = 0; i < n; i++) {
            grid.computeIfAbsent(cell(sheet, i, reach, 0, 0, 0), k -> new ArrayList<>())
                    .add(i);
        }
        opposing = new int[n][];
        for (int i = 0; i < n; i++) {
            List<double[]> found = new ArrayList<>();
            for (int c = 0; c < 27; c++) {
                List<Integer> near = grid.get(cell(sheet, i, reach, c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1));
                if (near == null) {
                    continue;
                }
                for (int j : near) {
                    double d = distance(sheet, i, j);
                    if (d <= reach && d > SHORTEST_MM && opposite.test(i, j) && dot(normals, i, j) < OPPOSING) {
                        found.add(new double[] {d, j});
                    }
                }
            }
            found.sort(Comparator.<double[]>comparingDouble(f -> f[0]).thenComparingDouble(f -> f[1]));
            opposing[i] = found.stream().mapToInt(f -> (int) f[1]).toArray();
        }
    }

    private static long cell(TriangleMesh m, int i, double size, int dx, int dy, int dz) {
        long x = (long) Math.floor(m.x(i) / size) + dx;
        long y = (long) Math.floor(m.y(i) / size) + dy;
        long z = (long) Math.floor(m.z(i) / size) + dz;
        return (x & 0x1fffff) << 42 | (y & 0x1fffff) << 21 | (z & 0x1fffff);
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
        TreeSet<Long> keys = new TreeSet<>();
        for (int i = 0; i < opposing.length; i++) {
            for (int k = 0; k < Math.min(most, opposing[i].length); k++) {
                int j = opposing[i][k];
                keys.add((long) Math.min(i, j) << 32 | Math.max(i, j));
            }
        }
        return keys.stream().map(k -> new Pair((int) (k >> 32), (int) (long) k)).toList();
    }

    /**
     * Pairs between chosen vertices, shortest first, a vertex in at most so many of them. As rigid links of the tendon: with one a vertex a single pass puts
     * all of them right exactly.
     */
    public List<Pair> matched(IntPredicate chosen, int mostPerVertex) {
        List<Pair> candidates = new ArrayList<>();
        for (int i = 0; i < opposing.length; i++) {
            for (int j : opposing[i]) {
                if (i < j && chosen.test(i) && chosen.test(j)) {
                    candidates.add(new Pair(i, j));
                }
            }
        }
        candidates.sort(Comparator.<Pair>comparingDouble(p -> distance(sheet, p.a, p.b))
                .thenComparingInt(Pair::a)
                .thenComparingInt(Pair::b));
        int[] used = new int[opposing.length];
        List<Pair> links = new ArrayList<>();
        for (Pair p : candidates) {
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
