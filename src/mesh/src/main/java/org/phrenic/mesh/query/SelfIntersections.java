package org.phrenic.mesh.query;

import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/** Self-intersections of a surface: its edges that pass through a triangle without a common vertex. */
public final class SelfIntersections {
    private interface Crossing {
        void at(int edge, int triangle);
    }

    private final int[] corners;
    private final TriangleTree tree;
    private final SegmentProbe probe = new SegmentProbe();
    private double[] positions;

    public SelfIntersections(TriangleMesh mesh) {
        corners = mesh.triangles();
        positions = mesh.positions();
        tree = new TriangleTree(mesh);
    }

    /** Number of edges that pass through another triangle. */
    public static int count(TriangleMesh mesh) {
        return new SelfIntersections(mesh).visit(new MeshTopology(mesh).edges(), (edge, triangle) -> {});
    }

    /** Moves the vertices of the surface, three numbers each. */
    public void moveTo(double[] positions) {
        this.positions = positions;
        tree.refit(positions);
    }

    /**
     * Marks the vertices of edges and triangles that pass through each other.
     *
     * @param edges those of the surface that are tried, two vertices each
     */
    public boolean[] vertices(int[] edges) {
        boolean[] crossing = new boolean[positions.length / 3];
        visit(edges, (edge, triangle) -> {
            crossing[edges[2 * edge]] = true;
            crossing[edges[2 * edge + 1]] = true;
            for (int c = 3 * triangle; c < 3 * triangle + 3; c++) {
                crossing[corners[c]] = true;
            }
        });
        return crossing;
    }

    /** @param each receives an edge and the first triangle that it passes through */
    private int visit(int[] edges, Crossing each) {
        double[] p = positions;
        int count = 0;
        for (int e = 0; e < edges.length; e += 2) {
            int a = 3 * edges[e];
            int b = 3 * edges[e + 1];
            probe.set(p[a], p[a + 1], p[a + 2], p[b], p[b + 1], p[b + 2]);
            int through = firstThrough(edges[e], edges[e + 1]);
            if (through >= 0) {
                each.at(e / 2, through);
                count++;
            }
        }
        return count;
    }

    /** The first triangle that the edge of the probe passes through; -1 if there is none. */
    private int firstThrough(int a, int b) {
        int found = probe.intersect(tree);
        for (int i = 0; i < found; i++) {
            int t = 3 * probe.triangle(i);
            boolean shared = false;
            for (int c = t; c < t + 3; c++) {
                shared |= corners[c] == a || corners[c] == b;
            }
            if (!shared) {
                return t / 3;
            }
        }
        return -1;
    }
}
