package org.phrenic.mesh.edit;

import java.util.Arrays;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Isotropic remeshing to a given number of vertices (Botsch and Kobbelt 2004, A Remeshing Approach to Multiresolution
 * Modeling, doi 10.1145/1057432.1057457). Edges longer than 4/3 of the target length are split, edges shorter than 4/5
 * are collapsed, other edges are flipped towards Delaunay, and vertices are relaxed on the original surface. The target
 * length follows from the vertex count. At the end single splits or collapses reach the exact count where the topology
 * allows it.
 *
 * <p>When refining, edges bent by more than 60 degrees are creases: they keep their position and are only split. When
 * coarsening, sharp edges are treated as detail below the new edge length and are not preserved.
 *
 * <p>Closedness, genus and boundary loops are preserved. Chords of a convex surface lie inside it, so remeshing loses
 * volume. On a closed surface all vertices are finally offset along their normals by one distance that restores it.
 */
public final class Remesher {
    private static final double LONG = 4.0 / 3;
    private static final double SHORT = 4.0 / 5;
    /** An edge is a crease if the cosine between its triangle normals is below this (a bend of 60 degrees). */
    private static final double CREASE = 0.5;

    /**
     * In the final collapses, edges below this fraction of the target length may rotate triangles by up to 110 degrees.
     */
    private static final double SHORT_AT_END = 0.4;

    /** In the final collapses, edges below this fraction of the target length may rotate triangles by any angle. */
    private static final double TINY_AT_END = 0.25;

    private static final int MIN_VERTICES = 12;
    private static final int MAX_VERTICES = 20_000_000;
    private static final int ROUNDS = 4;
    private static final int FINAL_ROUNDS = 3;
    private static final int MAX_SWEEPS = 12;
    /** Greatest search distance for the projection onto the original surface, in target lengths. */
    private static final double REACH = 2;

    private final TriangleMesh original;
    private final int vertices;
    private final HalfEdgeMesh mesh;
    private final EdgeCollapser collapser;
    private final EdgeFlipper flipper;
    private final VertexRelaxer relaxer;
    private double length;

    private Remesher(TriangleMesh original, int vertices) {
        this.original = original;
        this.vertices = vertices;
        mesh = new HalfEdgeMesh(original);
        collapser = new EdgeCollapser(mesh);
        flipper = new EdgeFlipper(mesh);
        length = targetLength();
        if (length < meanEdge()) {
            markCreases();
        }
        relaxer = new VertexRelaxer(mesh, new TriangleTree(original), new TriangleTree(linesOf(mesh)));
    }

    /**
     * Remeshes to {@code vertices} evenly spaced vertices with the same shape and topology. The result has more
     * vertices only if fewer would change the topology.
     *
     * @param mesh consistently oriented ({@link MeshRepair#repair}); it is cut open where it is not manifold
     * @param vertices at least 4
     * @throws IllegalArgumentException if the mesh has no area or fewer than 4 vertices are requested
     */
    public static TriangleMesh toVertexCount(TriangleMesh mesh, int vertices) {
        if (vertices < 4) {
            throw new IllegalArgumentException("remeshing to " + vertices + " vertices, expected at least 4");
        }
        if (!(MeshMeasure.area(mesh) > 0)) {
            throw new IllegalArgumentException("remeshing " + mesh + ", expected a surface with area");
        }
        return new Remesher(mesh, vertices).run();
    }

    /**
     * Remeshes to the number of vertices that gives equilateral triangles with this edge length; see
     * {@link #toVertexCount}.
     *
     * @param edgeMm above 0
     * @throws IllegalArgumentException if the mesh has no area or the edge length is not positive
     */
    public static TriangleMesh toEdgeLength(TriangleMesh mesh, double edgeMm) {
        if (!(edgeMm > 0)) {
            throw new IllegalArgumentException("remeshing to edges of " + edgeMm + " mm, expected more than 0");
        }
        // A closed surface with F triangles and Euler characteristic chi has V = F / 2 + chi vertices.
        double triangles = MeshMeasure.area(mesh) / (Math.sqrt(3) / 4 * edgeMm * edgeMm);
        return toVertexCount(mesh, (int) Math.max(MIN_VERTICES, Math.min(MAX_VERTICES, Math.rint(triangles / 2 + 2))));
    }

    private TriangleMesh run() {
        flipper.flipAll();
        for (int round = 0; round < ROUNDS; round++) {
            splitLong(LONG * length);
            collapseShort();
            flipper.flipAll();
            relaxer.relax(REACH * length);
            double excess = Math.sqrt((double) mesh.vertexCount() / vertices);
            length *= Math.max(0.8, Math.min(1.25, excess));
        }
        meetCount();
        for (int round = 0; round < FINAL_ROUNDS; round++) {
            flipper.flipAll();
            relaxer.relax(REACH * length);
            collapser.collapse(TINY_AT_END * length, 2 * length, 4, EdgeCollapser.ANY_TURN);
            collapser.collapse(SHORT_AT_END * length, 2 * length, 4, EdgeCollapser.UP_TO_110_DEG);
            meetCount();
        }
        flipper.flipAll();
        return restoreVolume(mesh.toMesh());
    }

    /** Edge length of the equilateral triangles that cover the area: F = 2 (V - euler) - B with B boundary vertices. */
    private double targetLength() {
        double area = MeshMeasure.area(original);
        double boundary = 0;
        int edges = 0;
        for (int h = 0; h < 3 * mesh.triangleEnd; h++) {
            if (mesh.twin[h] == HalfEdgeMesh.NONE) {
                boundary += Math.sqrt(mesh.squareLength(h));
            }
            edges += mesh.isPrimary(h) ? 1 : 0;
        }
        int euler = mesh.vertexCount() - edges + mesh.triangleEnd;
        double guess = Math.sqrt(area / (Math.sqrt(3) / 4 * Math.max(2, 2.0 * (vertices - euler))));
        for (int i = 0; i < 20; i++) {
            double faces = Math.max(2, 2.0 * (vertices - euler) - boundary / guess);
            guess = 0.5 * (guess + Math.sqrt(area / (Math.sqrt(3) / 4 * faces)));
        }
        return guess;
    }

    private double meanEdge() {
        double sum = 0;
        int edges = 0;
        for (int h = 0; h < 3 * mesh.triangleEnd; h++) {
            if (mesh.isPrimary(h)) {
                sum += Math.sqrt(mesh.squareLength(h));
                edges++;
            }
        }
        return sum / edges;
    }

    private void markCreases() {
        double[] normals = MeshMeasure.triangleNormals(mesh.toMesh());
        for (int h = 0; h < 3 * mesh.triangleEnd; h++) {
            int o = mesh.twin[h];
            if (o < h && o != HalfEdgeMesh.NONE) {
                int s = h - h % 3;
                int t = o - o % 3;
                double cosine =
                        normals[s] * normals[t] + normals[s + 1] * normals[t + 1] + normals[s + 2] * normals[t + 2];
                if (cosine < CREASE) {
                    mesh.markCrease(h);
                }
            }
        }
    }

    private static TriangleMesh linesOf(HalfEdgeMesh mesh) {
        IntList t = new IntList();
        for (int h = 0; h < 3 * mesh.triangleEnd; h++) {
            if (mesh.twin[h] == HalfEdges.NONE || (mesh.crease[h] && mesh.isPrimary(h))) {
                t.add(mesh.start[h]);
                t.add(mesh.end(h));
                t.add(mesh.end(h));
            }
        }
        return new TriangleMesh(Arrays.copyOf(mesh.position, 3 * mesh.vertexEnd), t.toArray());
    }

    private void splitLong(double longest) {
        for (int sweep = 0; sweep < MAX_SWEEPS; sweep++) {
            if (splitLongest(longest, Integer.MAX_VALUE) == 0) {
                return;
            }
            flipper.flipAll();
        }
    }

    /** Splits edges longer than {@code above} at their midpoints, longest first, up to a number of vertices. */
    private int splitLongest(double above, int mostVertices) {
        long[] queue = mesh.sortedEdges(above * above, Double.POSITIVE_INFINITY, true);
        int done = 0;
        for (int k = 0; k < queue.length && mesh.vertexCount() < mostVertices; k++) {
            int h = (int) queue[k];
            if (mesh.squareLength(h) > above * above) {
                splitInMiddle(h);
                done++;
            }
        }
        return done;
    }

    private void splitInMiddle(int h) {
        double[] p = mesh.position;
        int a = 3 * mesh.start[h];
        int b = 3 * mesh.end(h);
        mesh.split(h, (p[a] + p[b]) / 2, (p[a + 1] + p[b + 1]) / 2, (p[a + 2] + p[b + 2]) / 2);
    }

    private void collapseShort() {
        for (int sweep = 0; sweep < MAX_SWEEPS; sweep++) {
            int before = mesh.vertexCount();
            collapser.collapse(SHORT * length, LONG * length, 4, EdgeCollapser.UP_TO_75_DEG);
            if (before - mesh.vertexCount() <= before / 100) {
                return;
            }
            flipper.flipAll();
        }
    }

    private void meetCount() {
        for (int sweep = 0; sweep < MAX_SWEEPS && mesh.vertexCount() != vertices; sweep++) {
            if (mesh.vertexCount() < vertices) {
                // The threshold falls gradually, so that neighbours of a split edge are split first.
                splitLongest(length * Math.max(0, 1.2 - 0.1 * sweep), vertices);
            } else {
                double reach = 1 + 0.25 * sweep;
                collapser.collapse(
                        SHORT * reach * length, LONG * reach * reach * length, vertices, EdgeCollapser.UP_TO_75_DEG);
            }
            flipper.flipAll();
        }
    }

    private TriangleMesh restoreVolume(TriangleMesh remeshed) {
        if (!mesh.inputClosed) {
            return remeshed;
        }
        double volume = MeshMeasure.signedVolume(original);
        TriangleMesh current = remeshed;
        for (int step = 0; step < 3; step++) {
            double shift = (volume - MeshMeasure.signedVolume(current)) / MeshMeasure.area(current);
            double[] normals = MeshMeasure.vertexNormals(current);
            double[] p = current.positions().clone();
            for (int i = 0; i < p.length; i++) {
                p[i] += shift * normals[i];
            }
            current = current.withPositions(p);
        }
        return current;
    }
}
