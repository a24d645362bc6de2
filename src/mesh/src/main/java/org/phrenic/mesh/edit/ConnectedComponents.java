package org.phrenic.mesh.edit;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.TriangleMesh;

/** Takes a mesh apart into the pieces that hang together by triangles. */
public final class ConnectedComponents {
    private ConnectedComponents() {}

    /** The connected components that have triangles, in the order of their lowest vertex. */
    public static List<TriangleMesh> of(TriangleMesh mesh) {
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
                meshes.add(MeshRepair.compact(mesh.positions(), piece, used));
            }
        }
        return meshes;
    }

    /** For each vertex the lowest vertex that hangs together with it by triangles. */
    private static int[] lowestOfComponent(TriangleMesh mesh) {
        int[] lower = DisjointSets.singletons(mesh.vertexCount());
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i++) {
            DisjointSets.unionToLower(lower, t[i], t[i - i % 3]);
        }
        for (int v = 0; v < lower.length; v++) {
            lower[v] = lower[lower[v]];
        }
        return lower;
    }
}
