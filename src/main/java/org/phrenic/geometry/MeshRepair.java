package org.phrenic.geometry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Makes a usable surface of what a file or a segmentation holds: welds vertices, drops what has no area or stands twice,
 * turns triangles to one side, closes holes, splits into components. Every step keeps the order of what it keeps, so that
 * the same input gives the same output.
 */
public final class MeshRepair {
    /** Twice the area over the square of the longest side, below which a triangle is a line: an angle of 1e-12 rad. */
    private static final double FLAT = 1e-12;

    private MeshRepair() {}

    /** What a repair did, as counts. */
    public record Report(
            int verticesWelded,
            int degenerateRemoved,
            int duplicatesRemoved,
            int unusedRemoved,
            int trianglesFlipped,
            int loopsCapped) {
        static final Report NOTHING = new Report(0, 0, 0, 0, 0, 0);

        Report and(Report other) {
            return new Report(
                    verticesWelded + other.verticesWelded,
                    degenerateRemoved + other.degenerateRemoved,
                    duplicatesRemoved + other.duplicatesRemoved,
                    unusedRemoved + other.unusedRemoved,
                    trianglesFlipped + other.trianglesFlipped,
                    loopsCapped + other.loopsCapped);
        }

        @Override
        public String toString() {
            List<String> parts = new ArrayList<>();
            say(parts, verticesWelded, "vertices welded");
            say(parts, degenerateRemoved, "degenerate triangles removed");
            say(parts, duplicatesRemoved, "duplicate triangles removed");
            say(parts, unusedRemoved, "unused vertices removed");
            say(parts, trianglesFlipped, "triangles flipped");
            say(parts, loopsCapped, "boundary loops capped");
            return parts.isEmpty() ? "Nothing to repair." : "Repaired: " + String.join(", ", parts) + ".";
        }

        private static void say(List<String> parts, int count, String what) {
            if (count > 0) {
                parts.add(count + " " + what);
            }
        }
    }

    /** A mesh and what was done to get it. */
    public record Result(TriangleMesh mesh, Report report) {}

    /** {@link #weld}, {@link #clean}, {@link #orient} in turn. */
    public static Result repair(TriangleMesh mesh, double tolerance) {
        return repair(mesh, tolerance, 0);
    }

    /**
     * {@link #weld}, {@link #clean}, {@link #orient} in turn, and before the last of them the seams between the patches of the surface closed ({@link SeamStitcher}): a file's patches may differ along their common rim by more than
     * two vertices may inside one of them.
     *
     * @param tolerance of all vertices, mm
     * @param seam of those on open edges, mm; not above the tolerance nothing more is done
     */
    public static Result repair(TriangleMesh mesh, double tolerance, double seam) {
        Result joined = weld(mesh, tolerance);
        Report report = joined.report();
        TriangleMesh welded = joined.mesh();
        EdgeTable edges = new EdgeTable(welded);
        if (seam > tolerance && !edges.isClosed()) {
            joined = SeamStitcher.stitch(welded, edges, seam);
            report = report.and(joined.report());
        }
        Result cleaned = clean(joined.mesh());
        // Most meshes need nothing: what changes nothing hands its mesh on.
        if (cleaned.mesh() != welded) {
            edges = new EdgeTable(cleaned.mesh());
        }
        Result oriented = orient(cleaned.mesh(), edges);
        return new Result(oriented.mesh(), report.and(cleaned.report()).and(oriented.report()));
    }

    /** {@link #repair}, then {@link #cap}, then {@link #orient} again: what the caps closed now faces outward. */
    public static Result repairAndCap(TriangleMesh mesh, double tolerance) {
        Result repaired = repair(mesh, tolerance);
        Result capped = cap(repaired.mesh());
        Result oriented = orient(capped.mesh());
        return new Result(
                oriented.mesh(), repaired.report().and(capped.report()).and(oriented.report()));
    }

    /**
     * Replaces each vertex by the nearest earlier kept vertex within {@code tolerance} (mm), the earliest of equals; a vertex
     * that has none is kept. Vertices that lose their place are dropped.
     *
     * @param tolerance mm, at least 0; 0 welds equal coordinates only
     */
    public static Result weld(TriangleMesh mesh, double tolerance) {
        if (!(tolerance >= 0) || Double.isInfinite(tolerance)) {
            throw new IllegalArgumentException("weld tolerance: " + tolerance + " mm, expected a finite number from 0");
        }
        return merge(mesh, new VertexWelder(mesh.positions(), tolerance).keepers());
    }

    /** Lets each vertex's keeper stand for it. */
    static Result merge(TriangleMesh mesh, int[] keeper) {
        int welded = 0;
        for (int v = 0; v < keeper.length; v++) {
            welded += keeper[v] == v ? 0 : 1;
        }
        if (welded == 0) {
            return new Result(mesh, Report.NOTHING);
        }
        int[] triangles = mesh.triangles().clone();
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = keeper[triangles[i]];
        }
        boolean[] keep = new boolean[keeper.length];
        for (int v = 0; v < keep.length; v++) {
            keep[v] = keeper[v] == v;
        }
        return new Result(compact(mesh.positions(), triangles, keep), new Report(welded, 0, 0, 0, 0, 0));
    }

    /**
     * Drops triangles that name a vertex twice or have no area (all corners on one line), the later of triangles with the same
     * three vertices, and vertices that no triangle uses.
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
            boolean noArea = a == b || b == c || c == a || isFlat(mesh, i, normal);
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
            return new Result(mesh, Report.NOTHING);
        }
        TriangleMesh cleaned = compact(mesh.positions(), Arrays.copyOf(kept, length), used);
        return new Result(cleaned, new Report(0, degenerate, duplicates, unused, 0, 0));
    }

    private static boolean isFlat(TriangleMesh mesh, int triangle, double[] normal) {
        double twiceArea = MeshMeasure.crossOfTriangle(mesh, triangle, normal);
        int[] t = mesh.triangles();
        double longest = Math.max(
                MeshMeasure.distance(mesh, t[3 * triangle], t[3 * triangle + 1]),
                Math.max(
                        MeshMeasure.distance(mesh, t[3 * triangle + 1], t[3 * triangle + 2]),
                        MeshMeasure.distance(mesh, t[3 * triangle + 2], t[3 * triangle])));
        return !(twiceArea > FLAT * longest * longest);
    }

    /**
     * Turns triangles so that neighbours across every manifold edge agree. A piece that is closed then faces outward (positive
     * signed volume); of an open piece the side that more of its triangles already showed is kept. A one-sided surface cannot
     * agree everywhere and keeps a seam.
     */
    public static Result orient(TriangleMesh mesh) {
        return orient(mesh, new EdgeTable(mesh));
    }

    private static Result orient(TriangleMesh mesh, EdgeTable edges) {
        int[] given = mesh.triangles();
        int count = mesh.triangleCount();
        boolean[] done = new boolean[count];
        boolean[] flip = new boolean[count];
        int[] queue = new int[count];
        int flipped = 0;
        for (int seed = 0; seed < count; seed++) {
            if (done[seed]) {
                continue;
            }
            int head = 0;
            int tail = 0;
            queue[tail++] = seed;
            done[seed] = true;
            boolean closed = true;
            int turned = 0;
            while (head < tail) {
                int triangle = queue[head++];
                turned += flip[triangle] ? 1 : 0;
                closed &= edges.hasPairs(triangle);
                tail = turnNeighbours(edges, given, triangle, done, flip, queue, tail);
            }
            boolean inverted = closed ? volume(mesh, queue, tail, flip) < 0 : 2 * turned > tail;
            for (int k = 0; k < tail; k++) {
                flip[queue[k]] ^= inverted;
            }
            flipped += inverted ? tail - turned : turned;
        }
        if (flipped == 0) {
            return new Result(mesh, Report.NOTHING);
        }
        int[] t = given.clone();
        for (int i = 0; i < count; i++) {
            if (flip[i]) {
                t[3 * i + 1] = given[3 * i + 2];
                t[3 * i + 2] = given[3 * i + 1];
            }
        }
        return new Result(new TriangleMesh(mesh.positions(), t), new Report(0, 0, 0, 0, flipped, 0));
    }

    /** Enters the neighbours of a triangle that are not done yet, turned to its side, into the queue; returns the queue's new end. */
    private static int turnNeighbours(
            EdgeTable edges, int[] t, int triangle, boolean[] done, boolean[] flip, int[] queue, int queueEnd) {
        int end = queueEnd;
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            int edge = edges.triangleEdges[side];
            if (edge == EdgeTable.NONE || edges.edgeTriangleCount[edge] != 2) {
                continue;
            }
            int other = edges.otherTriangle(edge, triangle);
            if (!done[other]) {
                done[other] = true;
                flip[other] = flip[triangle] ^ runsAlong(t, other, t[side], t[EdgeTable.next(side)]);
                queue[end++] = other;
            }
        }
        return end;
    }

    private static boolean runsAlong(int[] t, int triangle, int from, int to) {
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            if (t[side] == from && t[EdgeTable.next(side)] == to) {
                return true;
            }
        }
        return false;
    }

    /** Signed volume of one closed piece about its first corner, which loses no digits far from the origin. */
    private static double volume(TriangleMesh mesh, int[] piece, int length, boolean[] flip) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        int o = 3 * t[3 * piece[0]];
        double sum = 0;
        for (int k = 0; k < length; k++) {
            int a = 3 * t[3 * piece[k]];
            int b = 3 * t[3 * piece[k] + 1];
            int c = 3 * t[3 * piece[k] + 2];
            double bx = p[b] - p[o];
            double by = p[b + 1] - p[o + 1];
            double bz = p[b + 2] - p[o + 2];
            double cx = p[c] - p[o];
            double cy = p[c + 1] - p[o + 1];
            double cz = p[c + 2] - p[o + 2];
            double six = (p[a] - p[o]) * (by * cz - bz * cy)
                    + (p[a + 1] - p[o + 1]) * (bz * cx - bx * cz)
                    + (p[a + 2] - p[o + 2]) * (bx * cy - by * cx);
            sum += flip[piece[k]] ? -six : six;
        }
        return sum;
    }

    /** Closes each boundary loop: three edges by a triangle, more by a fan about the loop's centroid. */
    public static Result cap(TriangleMesh mesh) {
        List<int[]> loops = new MeshTopology(mesh).boundaryLoops();
        int newVertices = 0;
        int newCorners = 0;
        for (int[] loop : loops) {
            newVertices += loop.length > 3 ? 1 : 0;
            newCorners += loop.length > 3 ? 3 * loop.length : 3;
        }
        double[] p = Arrays.copyOf(mesh.positions(), mesh.positions().length + 3 * newVertices);
        int[] t = Arrays.copyOf(mesh.triangles(), mesh.triangles().length + newCorners);
        int vertex = mesh.vertexCount();
        int corner = mesh.triangles().length;
        for (int[] loop : loops) {
            if (loop.length == 3) {
                t[corner++] = loop[0];
                t[corner++] = loop[2];
                t[corner++] = loop[1];
                continue;
            }
            for (int k = 0; k < loop.length; k++) {
                for (int axis = 0; axis < 3; axis++) {
                    p[3 * vertex + axis] += p[3 * loop[k] + axis] / loop.length;
                }
                t[corner++] = loop[(k + 1) % loop.length];
                t[corner++] = loop[k];
                t[corner++] = vertex;
            }
            vertex++;
        }
        return new Result(new TriangleMesh(p, t), new Report(0, 0, 0, 0, 0, loops.size()));
    }

    /** The connected components that have triangles, in the order of their lowest vertex. */
    public static List<TriangleMesh> components(TriangleMesh mesh) {
        int[] label = lowestOfComponent(mesh);
        int[] t = mesh.triangles();
        int[] corners = new int[mesh.vertexCount()];
        for (int i = 0; i < t.length; i += 3) {
            corners[label[t[i]]] += 3;
        }
        int[][] pieces = new int[corners.length][];
        for (int c = 0; c < corners.length; c++) {
            pieces[c] = corners[c] == 0 ? null : new int[corners[c]];
        }
        int[] fill = new int[corners.length];
        for (int i = 0; i < t.length; i++) {
            int c = label[t[i - i % 3]];
            pieces[c][fill[c]++] = t[i];
        }
        List<TriangleMesh> meshes = new ArrayList<>();
        for (int[] piece : pieces) {
            if (piece != null) {
                boolean[] used = new boolean[mesh.vertexCount()];
                for (int v : piece) {
                    used[v] = true;
                }
                meshes.add(compact(mesh.positions(), piece, used));
            }
        }
        return meshes;
    }

    /** For each vertex the lowest vertex that hangs together with it by triangles. */
    private static int[] lowestOfComponent(TriangleMesh mesh) {
        int[] lower = new int[mesh.vertexCount()];
        for (int v = 0; v < lower.length; v++) {
            lower[v] = v;
        }
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i++) {
            int one = lowest(lower, t[i]);
            int other = lowest(lower, t[i - i % 3]);
            lower[Math.max(one, other)] = Math.min(one, other);
        }
        for (int v = 0; v < lower.length; v++) {
            lower[v] = lower[lower[v]];
        }
        return lower;
    }

    /** Follows the way down, and shortens it for those who come after. */
    private static int lowest(int[] lower, int vertex) {
        int v = vertex;
        while (lower[v] != v) {
            lower[v] = lower[lower[v]];
            v = lower[v];
        }
        return v;
    }

    /** Keeps the named vertices in their order and renames the corners (in place). */
    private static TriangleMesh compact(double[] positions, int[] triangles, boolean[] keep) {
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
