package org.phrenic.mesh.edit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * Repair of surfaces from files and segmentations. It welds vertices, closes seams, removes degenerate and duplicate
 * triangles, and orients triangles consistently. Each step preserves the order of the remaining elements, so equal
 * input gives equal output.
 */
public final class MeshRepair {
    /**
     * A triangle is degenerate if twice its area over its squared longest edge is below this: an angle of 1e-12 rad.
     */
    private static final double FLAT = 1e-12;

    private MeshRepair() {}

    /** Counts of the changes made by a repair. */
    public record Report(
            int verticesWelded, int degenerateRemoved, int duplicatesRemoved, int unusedRemoved, int trianglesFlipped) {
        static final Report NONE = new Report(0, 0, 0, 0, 0);

        Report plus(Report other) {
            return new Report(
                    verticesWelded + other.verticesWelded,
                    degenerateRemoved + other.degenerateRemoved,
                    duplicatesRemoved + other.duplicatesRemoved,
                    unusedRemoved + other.unusedRemoved,
                    trianglesFlipped + other.trianglesFlipped);
        }

        @Override
        public String toString() {
            List<String> parts = new ArrayList<>();
            addCount(parts, verticesWelded, "vertices welded");
            addCount(parts, degenerateRemoved, "degenerate triangles removed");
            addCount(parts, duplicatesRemoved, "duplicate triangles removed");
            addCount(parts, unusedRemoved, "unused vertices removed");
            addCount(parts, trianglesFlipped, "triangles flipped");
            return parts.isEmpty() ? "Nothing to repair." : "Repaired: " + String.join(", ", parts) + ".";
        }

        private static void addCount(List<String> parts, int count, String what) {
            if (count > 0) {
                parts.add(count + " " + what);
            }
        }
    }

    /** A repaired mesh and the counts of the changes. */
    public record Result(TriangleMesh mesh, Report report) {}

    /** Applies {@link #weld}, {@link #clean} and {@link #orient} in this order. */
    public static Result repair(TriangleMesh mesh, double tolerance) {
        return repair(mesh, tolerance, 0);
    }

    /**
     * Applies {@link #weld}, closes seams, then applies {@link #clean} and {@link #orient}. Vertices on open edges are
     * welded with a larger tolerance, because the common boundary of two patches may differ by more than the vertex
     * spacing inside a patch.
     *
     * @param tolerance welding distance of all vertices, mm
     * @param seam welding distance on open edges, mm; ignored unless above the tolerance
     */
    public static Result repair(TriangleMesh mesh, double tolerance, double seam) {
        Result joined = weld(mesh, tolerance);
        Report report = joined.report();
        TriangleMesh welded = joined.mesh();
        EdgeTable edges = new EdgeTable(welded);
        if (seam > tolerance && !edges.isClosed()) {
            joined = weldBoundaries(welded, edges, seam);
            report = report.plus(joined.report());
        }
        Result cleaned = clean(joined.mesh());
        // A step that changes nothing returns the same mesh.
        if (cleaned.mesh() != welded) {
            edges = new EdgeTable(cleaned.mesh());
        }
        Result oriented = MeshOrienter.orient(cleaned.mesh(), edges);
        return new Result(oriented.mesh(), report.plus(cleaned.report()).plus(oriented.report()));
    }

    /**
     * Merges each vertex into the nearest earlier kept vertex within {@code tolerance} (mm). Among equal distances the
     * earliest vertex is used. A vertex with no such neighbour is kept. Merged vertices are removed.
     *
     * @param tolerance mm, at least 0; 0 welds equal coordinates only
     */
    public static Result weld(TriangleMesh mesh, double tolerance) {
        if (!(tolerance >= 0) || Double.isInfinite(tolerance)) {
            throw new IllegalArgumentException("weld tolerance: " + tolerance + " mm, expected a finite number from 0");
        }
        return merge(mesh, new VertexWelder(mesh.positions(), tolerance).representatives());
    }

    /** Welds vertices on open edges within a distance, mm. Vertices inside a patch are not welded. */
    private static Result weldBoundaries(TriangleMesh mesh, EdgeTable edges, double distance) {
        int[] rim = boundaryVertices(mesh, edges);
        double[] p = mesh.positions();
        double[] places = new double[3 * rim.length];
        for (int i = 0; i < rim.length; i++) {
            System.arraycopy(p, 3 * rim[i], places, 3 * i, 3);
        }
        int[] keeperOfRim = new VertexWelder(places, distance).representatives();
        int[] keeper = new int[mesh.vertexCount()];
        Arrays.setAll(keeper, v -> v);
        for (int i = 0; i < rim.length; i++) {
            keeper[rim[i]] = rim[keeperOfRim[i]];
        }
        return merge(mesh, keeper);
    }

    /** The vertices of edges with one triangle, in ascending order. */
    private static int[] boundaryVertices(TriangleMesh mesh, EdgeTable edges) {
        boolean[] open = new boolean[mesh.vertexCount()];
        for (int e = 0; e < edges.edgeCount(); e++) {
            if (edges.faceCount(e) == 1) {
                open[edges.edges()[2 * e]] = true;
                open[edges.edges()[2 * e + 1]] = true;
            }
        }
        return IntStream.range(0, open.length).filter(v -> open[v]).toArray();
    }

    /** Replaces each vertex by its representative. */
    static Result merge(TriangleMesh mesh, int[] keeper) {
        int welded = 0;
        for (int v = 0; v < keeper.length; v++) {
            welded += keeper[v] == v ? 0 : 1;
        }
        if (welded == 0) {
            return new Result(mesh, Report.NONE);
        }
        int[] triangles = mesh.triangles().clone();
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = keeper[triangles[i]];
        }
        boolean[] keep = new boolean[keeper.length];
        for (int v = 0; v < keep.length; v++) {
            keep[v] = keeper[v] == v;
        }
        return new Result(compact(mesh.positions(), triangles, keep), new Report(welded, 0, 0, 0, 0));
    }

    /**
     * Removes degenerate triangles (a repeated vertex or collinear corners), duplicate triangles and unused vertices.
     * Of triangles with the same three vertices the first is kept.
     */
    public static Result clean(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        int[] kept = t;
        int length = 0;
        int degenerate = 0;
        int duplicates = 0;
        TripleSet seen = new TripleSet(mesh.triangleCount());
        double[] normal = new double[3];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            int a = t[3 * i];
            int b = t[3 * i + 1];
            int c = t[3 * i + 2];
            boolean noArea = a == b || b == c || c == a || isDegenerate(mesh, i, normal);
            if (noArea || !seen.add(a, b, c)) {
                degenerate += noArea ? 1 : 0;
                duplicates += noArea ? 0 : 1;
                kept = kept == t ? t.clone() : kept;
                continue;
            }
            if (kept != t) {
                kept[length] = a;
                kept[length + 1] = b;
                kept[length + 2] = c;
            }
            length += 3;
        }
        boolean[] used = new boolean[mesh.vertexCount()];
        int count = 0;
        for (int k = 0; k < length; k++) {
            count += used[kept[k]] ? 0 : 1;
            used[kept[k]] = true;
        }
        int unused = mesh.vertexCount() - count;
        if (length == t.length && unused == 0) {
            return new Result(mesh, Report.NONE);
        }
        TriangleMesh cleaned = compact(mesh.positions(), Arrays.copyOf(kept, length), used);
        return new Result(cleaned, new Report(0, degenerate, duplicates, unused, 0));
    }

    private static boolean isDegenerate(TriangleMesh mesh, int triangle, double[] normal) {
        double twiceArea = MeshMeasure.triangleCrossProduct(mesh, triangle, normal);
        int[] t = mesh.triangles();
        double longest = Math.max(
                MeshMeasure.distance(mesh, t[3 * triangle], t[3 * triangle + 1]),
                Math.max(
                        MeshMeasure.distance(mesh, t[3 * triangle + 1], t[3 * triangle + 2]),
                        MeshMeasure.distance(mesh, t[3 * triangle + 2], t[3 * triangle])));
        return !(twiceArea > FLAT * longest * longest);
    }

    /**
     * Orients triangles consistently across every manifold edge. A closed component then faces outward (positive signed
     * volume), or inward within an odd number of other closed ones, as the shell of a cavity. An open component keeps
     * the orientation of the majority of its triangles. A non-orientable surface keeps an inconsistent seam.
     */
    public static Result orient(TriangleMesh mesh) {
        return MeshOrienter.orient(mesh, new EdgeTable(mesh));
    }

    /** Keeps the marked vertices in order and renumbers the triangle corners in place. */
    static TriangleMesh compact(double[] positions, int[] triangles, boolean[] keep) {
        int[] rename = new int[keep.length];
        int count = 0;
        for (int v = 0; v < keep.length; v++) {
            rename[v] = count;
            count += keep[v] ? 1 : 0;
        }
        double[] kept = new double[3 * count];
        for (int v = 0; v < keep.length; v++) {
            if (keep[v]) {
                System.arraycopy(positions, 3 * v, kept, 3 * rename[v], 3);
            }
        }
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = rename[triangles[i]];
        }
        return new TriangleMesh(kept, triangles);
    }
}
