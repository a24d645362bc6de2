package org.phrenic.mesh.edit;

import java.util.List;
import org.phrenic.mesh.TriangleMesh;

/** Putting several surfaces into one. */
public final class MeshMerge {
    private MeshMerge() {}

    /** All triangles of all meshes, vertices one mesh after the other. */
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
