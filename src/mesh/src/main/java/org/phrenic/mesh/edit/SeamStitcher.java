package org.phrenic.mesh.edit;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;

/**
 * Closes the seams of a surface that is given in patches: vertices on open edges that lie within a distance of each
 * other become one. Vertices inside a patch stay as they are, so that the distance may be greater than the finest
 * detail of a surface that is closed already.
 */
final class SeamStitcher {
    private SeamStitcher() {}

    /**
     * Welds the vertices of the rims.
     *
     * @param edges of the mesh
     * @param distance mm, above 0
     */
    static MeshRepair.Result stitch(TriangleMesh mesh, EdgeTable edges, double distance) {
        int[] rim = boundaryVertices(mesh, edges);
        double[] p = mesh.positions();
        double[] places = new double[3 * rim.length];
        for (int i = 0; i < rim.length; i++) {
            System.arraycopy(p, 3 * rim[i], places, 3 * i, 3);
        }
        int[] keeperOfRim = new VertexWelder(places, distance).representatives();
        int[] keeper = new int[mesh.vertexCount()];
        Arrays.setAll(keeper, v -> v);
        for (int i = 0; i < rim.length; i++) {
            keeper[rim[i]] = rim[keeperOfRim[i]];
        }
        return MeshRepair.merge(mesh, keeper);
    }

    /** The vertices that have an edge with one triangle, in their order. */
    private static int[] boundaryVertices(TriangleMesh mesh, EdgeTable edges) {
        boolean[] open = new boolean[mesh.vertexCount()];
        for (int e = 0; e < edges.edgeCount(); e++) {
            if (edges.faceCount(e) == 1) {
                open[edges.edges()[2 * e]] = true;
                open[edges.edges()[2 * e + 1]] = true;
            }
        }
        return IntStream.range(0, open.length).filter(v -> open[v]).toArray();
    }
}
