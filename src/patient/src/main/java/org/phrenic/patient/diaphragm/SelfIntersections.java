package org.phrenic.patient.diaphragm;

import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;

/** Self-intersections of a surface: its edges that pass through a triangle without a common vertex. */
public final class SelfIntersections {
    private SelfIntersections() {}

    /** Number of edges that pass through another triangle. */
    public static int count(TriangleMesh mesh) {
        int[] edges = new MeshTopology(mesh).edges();
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
            }
            count += through ? 1 : 0;
        }
        return count;
    }
}
