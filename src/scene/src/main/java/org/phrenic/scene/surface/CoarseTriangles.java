package org.phrenic.scene.surface;

import org.phrenic.file.Hashes;
import org.phrenic.file.SoftValues;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.Decimator;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Level of detail: fewer triangles between a part of the same vertices, so that a surface that deforms is drawn more
 * coarsely without other positions or normals. The surface is decimated at rest, and each vertex that is left is
 * replaced by the nearest corner of the triangle on which it lies.
 */
public final class CoarseTriangles {
    /** Vertices that are left, as a share of all. */
    private static final double SHARE = 0.25;
    /** A surface of fewer vertices is drawn as it is. */
    private static final int LEAST_VERTICES = 200;
    /** By the surface: bones and organs are the same in each scene of a body. */
    private static final SoftValues<int[]> KEPT = new SoftValues<>();

    private CoarseTriangles() {}

    /**
     * Triangles of the coarser surface, kept while memory allows for the next scene that shows it.
     *
     * @param mesh the surface at rest
     * @return three vertices of {@code mesh} each; its own triangles if it has few; not to be changed
     */
    public static int[] of(TriangleMesh mesh) {
        if (mesh.vertexCount() < LEAST_VERTICES) {
            return mesh.triangles();
        }
        String surface = Hashes.sha256(mesh.positions()) + Hashes.sha256(mesh.triangles());
        return KEPT.get(surface, () -> decimated(mesh));
    }

    private static int[] decimated(TriangleMesh mesh) {
        TriangleMesh coarse =
                Decimator.toVertexCount(mesh, (int) (SHARE * mesh.vertexCount()), Double.POSITIVE_INFINITY);
        TriangleTree tree = new TriangleTree(mesh);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int[] nearest = new int[coarse.vertexCount()];
        for (int v = 0; v < nearest.length; v++) {
            tree.closest(coarse.x(v), coarse.y(v), coarse.z(v), hit);
            nearest[v] = mesh.triangles()[3 * hit.triangle + heaviest(hit)];
        }
        int[] t = coarse.triangles();
        IntList kept = new IntList();
        for (int i = 0; i < t.length; i += 3) {
            int a = nearest[t[i]];
            int b = nearest[t[i + 1]];
            int c = nearest[t[i + 2]];
            if (a != b && b != c && c != a) {
                kept.add(a);
                kept.add(b);
                kept.add(c);
            }
        }
        return kept.toArray();
    }

    private static int heaviest(TriangleTree.Hit hit) {
        return hit.weightA >= Math.max(hit.weightB, hit.weightC) ? 0 : hit.weightB >= hit.weightC ? 1 : 2;
    }
}
