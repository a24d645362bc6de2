package org.phrenic.mesh.edit;

import java.util.List;
import org.phrenic.mesh.TriangleMesh;

/** Concatenates meshes. */
public final class MeshMerge {
    private MeshMerge() {}

    /** One mesh with the vertices and triangles of all parts, in the order of the parts. No vertices are welded. */
    public static TriangleMesh merge(List<TriangleMesh> parts) {
        double[] positions =
                new double[parts.stream().mapToInt(m -> m.positions().length).sum()];
        int[] triangles =
                new int[parts.stream().mapToInt(m -> m.triangles().length).sum()];
        int p = 0;
        int t = 0;
        for (TriangleMesh mesh : parts) {
            int first = p / 3;
            System.arraycopy(mesh.positions(), 0, positions, p, mesh.positions().length);
            p += mesh.positions().length;
            for (int corner : mesh.triangles()) {
                triangles[t++] = first + corner;
            }
        }
        return new TriangleMesh(positions, triangles);
    }
}
