package org.phrenic.mesh.query;

import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/** Self-intersections of a surface: its edges that pass through a triangle without a common vertex. */
public final class SelfIntersections {
    private interface Crossing {
        void at(int edge, int triangle);
    }

    private SelfIntersections() {}

    /** Number of edges that pass through another triangle. */
    public static int count(TriangleMesh mesh) {
        return visit(mesh, new MeshTopology(mesh).edges(), (edge, triangle) -> {});
    }

    /**
     * Marks the vertices of edges and triangles that pass through each other.
     *
     * @param edges of the mesh, two vertices each
     */
    public static boolean[] vertices(TriangleMesh mesh, int[] edges) {
        boolean[] crossing = new boolean[mesh.vertexCount()];
        int[] corners = mesh.triangles();
        visit(mesh, edges, (edge, triangle) -> {
            crossing[edges[2 * edge]] = true;
            crossing[edges[2 * edge + 1]] = true;
            for (int c = 3 * triangle; c < 3 * triangle + 3; c++) {
                crossing[corners[c]] = true;
            }
        });
        return crossing;
    }

    /** @param each receives an edge and the first triangle that it passes through */
    private static int visit(TriangleMesh mesh, int[] edges, Crossing each) {
        int[] corners = mesh.triangles();
        TriangleTree tree = new TriangleTree(mesh);
        SegmentProbe probe = new SegmentProbe();
        int count = 0;
        for (int e = 0; e < edges.length; e += 2) {
            int a = edges[e];
            int b = edges[e + 1];
            probe.set(mesh.x(a), mesh.y(a), mesh.z(a), mesh.x(b), mesh.y(b), mesh.z(b));
            int found = probe.intersect(tree);
            boolean through = false;
            for (int i = 0; i < found && !through; i++) {
                int t = 3 * probe.triangle(i);
                boolean shared = false;
                for (int c = t; c < t + 3; c++) {
                    shared |= corners[c] == a || corners[c] == b;
                }
                through = !shared;
                if (through) {
                    each.at(e / 2, t / 3);
                }
            }
            count += through ? 1 : 0;
        }
        return count;
    }
}
