package org.phrenic.anatomy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * Pairs of vertices across the thickness of a sheet, by the rule of Villard, Bourne and Bello 2009: take the vertices
 * within a given distance, reject those on the same face by an angle test, and sort the rest by distance.
 */
public final class OpposingVertices {
    /** Largest dot product of unit normals on opposing faces; vertices on the same face have a positive product. */
    private static final double MAX_NORMAL_PRODUCT = -0.25;
    /** Closer vertices belong to a seam between patches, not to the other face. */
    private static final double MIN_DISTANCE_MM = 0.2;

    /** Initial search radius, mm. It suffices for most vertices; the rest are searched up to the full distance. */
    private static final double NEAR_MM = 8;

    private final TriangleMesh sheet;
    private final double[] normals;
    /** Face of each vertex if known; null if only normals decide. */
    private final boolean[] face;

    private final double near;
    private final double reach;
    private final PointGrid far;
    /** Nearby opposing vertices of each vertex, sorted by distance. */
    private final int[][] opposing;

    private long[] found = new long[64];

    /** A pair of vertices. */
    public record Pair(int a, int b) {}

    /**
     * Finds pairs across the thickness of the diaphragm.
     *
     * @param diaphragm diaphragm with known faces
     * @param reach maximum distance, mm
     */
    public static OpposingVertices of(Diaphragm diaphragm, double reach) {
        boolean[] thoracic = new boolean[diaphragm.sheet().vertexCount()];
        for (int i = 0; i < thoracic.length; i++) {
            thoracic[i] = diaphragm.isThoracic(i);
        }
        return new OpposingVertices(diaphragm.sheet(), reach, thoracic);
    }

    /**
     * Finds pairs across a closed body that is thin in at least one direction (a cartilage, a sternum), by normals
     * only.
     *
     * @param body closed surface
     * @param reach maximum distance, mm
     */
    public static OpposingVertices of(TriangleMesh body, double reach) {
        return new OpposingVertices(body, reach, null);
    }

    private OpposingVertices(TriangleMesh sheet, double reach, boolean[] face) {
        this.sheet = sheet;
        this.reach = reach;
        this.face = face;
        normals = MeshMeasure.vertexNormals(sheet);
        near = Math.min(reach, NEAR_MM);
        PointGrid grid = new PointGrid(sheet.positions(), near);
        far = near < reach ? new PointGrid(sheet.positions(), reach) : grid;
        opposing = new int[sheet.vertexCount()][];
        for (int i = 0; i < opposing.length; i++) {
            opposing[i] = opposingWithin(grid, i, 0, near, null);
        }
    }

    /**
     * Opposing vertices of a vertex, sorted by distance.
     *
     * @param from lower bound of the distance, exclusive, mm
     * @param to upper bound of the distance, inclusive, mm
     * @param used excludes vertices that have their maximum number of pairs; null for no exclusion
     */
    private int[] opposingWithin(PointGrid grid, int i, double from, double to, Use used) {
        int count = 0;
        double[] p = sheet.positions();
        double x = p[3 * i];
        double y = p[3 * i + 1];
        double z = p[3 * i + 2];
        double least = Math.max(from * from, MIN_DISTANCE_MM * MIN_DISTANCE_MM);
        double most = to * to;
        for (int row = 0; row < 9; row++) {
            int end = grid.rowEnd(i, row);
            for (int k = grid.rowStart(i, row); k < end; k++) {
                int j = grid.point(k);
                double dx = p[3 * j] - x;
                double dy = p[3 * j + 1] - y;
                double dz = p[3 * j + 2] - z;
                double square = dx * dx + dy * dy + dz * dz;
                if (square <= most && square > least && isOpposite(i, j) && (used == null || used.mayTake(j))) {
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count);
                    }
                    insertSorted(byDistance(Math.sqrt(square), j), count++);
                }
            }
        }
        int[] out = new int[count];
        for (int k = 0; k < count; k++) {
            out[k] = (int) found[k];
        }
        return out;
    }

    private boolean isOpposite(int i, int j) {
        return (face == null || face[i] != face[j]) && dot(normals, i, j) < MAX_NORMAL_PRODUCT;
    }

    /** Insertion sort; few vertices are found. */
    private void insertSorted(long value, int count) {
        int k = count;
        while (k > 0 && found[k - 1] > value) {
            found[k] = found[k - 1];
            k--;
        }
        found[k] = value;
    }

    /** Key that sorts by distance, then by index. */
    private static long byDistance(double distance, int index) {
        return (long) Float.floatToIntBits((float) distance) << 32 | index;
    }

    private static double distance(TriangleMesh m, int i, int j) {
        double x = m.x(i) - m.x(j);
        double y = m.y(i) - m.y(j);
        double z = m.z(i) - m.z(j);
        return Math.sqrt(x * x + y * y + z * z);
    }

    static double dot(double[] v, int i, int j) {
        return v[3 * i] * v[3 * j] + v[3 * i + 1] * v[3 * j + 1] + v[3 * i + 2] * v[3 * j + 2];
    }

    /**
     * Pairs of each vertex with its nearest opposing vertices, at most {@code most} per vertex; no pair occurs twice.
     */
    public List<Pair> nearestPairs(int most) {
        long[] keys = new long[most * opposing.length];
        int count = 0;
        for (int i = 0; i < opposing.length; i++) {
            int[] others = opposing[i].length < most ? opposingWithin(far, i, 0, reach, null) : opposing[i];
            for (int k = 0; k < Math.min(most, others.length); k++) {
                keys[count++] = (long) Math.min(i, others[k]) << 32 | Math.max(i, others[k]);
            }
        }
        RadixSort.sort(keys, count);
        List<Pair> pairs = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            if (k == 0 || keys[k] != keys[k - 1]) {
                pairs.add(new Pair((int) (keys[k] >> 32), (int) keys[k]));
            }
        }
        return pairs;
    }

    /**
     * Greedy matching of chosen vertices by increasing distance, with a maximum number of pairs per vertex. With one
     * pair per vertex, rigid links in the tendon are independent, so that a single pass satisfies all of them exactly.
     */
    public List<Pair> greedyMatching(IntPredicate chosen, int mostPerVertex) {
        Use use = new Use(chosen, mostPerVertex);
        for (int i = 0; i < opposing.length; i++) {
            use.offer(i, opposing[i]);
        }
        use.takeShortestFirst();
        // Only vertices below their maximum number of pairs are searched farther.
        for (int i = 0; near < reach && i < opposing.length; i++) {
            if (use.mayTake(i)) {
                use.offer(i, opposingWithin(far, i, near, reach, use));
            }
        }
        use.takeShortestFirst();
        return use.pairs;
    }

    /** Candidate and accepted pairs, and the number of further pairs allowed per vertex. */
    private final class Use {
        final List<Pair> pairs = new ArrayList<>();
        private final int[] places = new int[opposing.length];
        private int[] first = new int[256];
        private int[] second = new int[256];
        private long[] order = new long[256];
        private int count;

        Use(IntPredicate chosen, int mostPerVertex) {
            for (int i = 0; i < places.length; i++) {
                places[i] = chosen.test(i) ? mostPerVertex : 0;
            }
        }

        boolean mayTake(int vertex) {
            return places[vertex] > 0;
        }

        void offer(int i, int[] others) {
            for (int j : others) {
                if (i < j && mayTake(i) && mayTake(j)) {
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

        void takeShortestFirst() {
            RadixSort.sort(order, count);
            for (int k = 0; k < count; k++) {
                int i = first[(int) order[k]];
                int j = second[(int) order[k]];
                if (mayTake(i) && mayTake(j)) {
                    places[i]--;
                    places[j]--;
                    pairs.add(new Pair(i, j));
                }
            }
            count = 0;
        }
    }
}
