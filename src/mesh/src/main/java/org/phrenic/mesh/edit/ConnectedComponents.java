package org.phrenic.mesh.edit;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;

/** Splits a mesh into its connected components. */
public final class ConnectedComponents {
    private ConnectedComponents() {}

    /** The connected components that have triangles, ordered by their lowest vertex index. */
    public static List<TriangleMesh> of(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        int[] parent = DisjointSets.singletons(mesh.vertexCount());
        for (int i = 0; i < t.length; i++) {
            DisjointSets.unionToLower(parent, t[i], t[i - i % 3]);
        }
        IntList[] pieces = new IntList[parent.length];
        for (int i = 0; i < t.length; i++) {
            int lowest = DisjointSets.find(parent, t[i]);
            pieces[lowest] = pieces[lowest] == null ? new IntList() : pieces[lowest];
            pieces[lowest].add(t[i]);
        }
        return Arrays.stream(pieces)
                .filter(Objects::nonNull)
                .map(piece -> component(mesh, piece.toArray()))
                .toList();
    }

    /** The component with the most triangles; of equals the first. The mesh itself if it has one component or none. */
    public static TriangleMesh largest(TriangleMesh mesh) {
        List<TriangleMesh> all = of(mesh);
        TriangleMesh best = all.size() == 1 ? mesh : all.stream().findFirst().orElse(mesh);
        for (TriangleMesh one : all) {
            best = one.triangleCount() > best.triangleCount() ? one : best;
        }
        return best;
    }

    private static TriangleMesh component(TriangleMesh mesh, int[] triangles) {
        boolean[] used = new boolean[mesh.vertexCount()];
        for (int v : triangles) {
            used[v] = true;
        }
        return MeshRepair.compact(mesh.positions(), triangles, used);
    }
}
