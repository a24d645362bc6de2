package org.phrenic.patient.diaphragm;

import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * A closed sheet of two faces about a middle surface. Of n vertices, vertex i lies on the thoracic face and vertex i +
 * n/2 is its partner on the abdominal face.
 */
final class TwoFacedSheet {
    private static final int NORMAL_PASSES = 6;

    private TwoFacedSheet() {}

    /**
     * Offsets a middle surface by half the thickness to either side and closes the border.
     *
     * @param middle open surface with one border, thoracic side outward
     */
    static TriangleMesh of(TriangleMesh middle, double thicknessMm) {
        int n = middle.vertexCount();
        double[] positions = new double[6 * n];
        double[] normals = smoothNormals(middle);
        for (int k = 0; k < 3 * n; k++) {
            positions[k] = middle.positions()[k] + 0.5 * thicknessMm * normals[k];
            positions[3 * n + k] = middle.positions()[k] - 0.5 * thicknessMm * normals[k];
        }
        int[] face = middle.triangles();
        MeshTopology topology = new MeshTopology(middle);
        int[] rim = new int[face.length];
        int count = 0;
        for (int side = 0; side < face.length; side++) {
            if (topology.faceCount(topology.edgeOfSide()[side]) == 1) {
                rim[count++] = side;
            }
        }
        int[] triangles = new int[2 * face.length + 6 * count];
        for (int t = 0; t < face.length; t += 3) {
            triangles[t] = face[t];
            triangles[t + 1] = face[t + 1];
            triangles[t + 2] = face[t + 2];
            triangles[face.length + t] = n + face[t];
            triangles[face.length + t + 1] = n + face[t + 2];
            triangles[face.length + t + 2] = n + face[t + 1];
        }
        int at = 2 * face.length;
        for (int i = 0; i < count; i++) {
            int a = face[rim[i]];
            int b = face[rim[i] % 3 == 2 ? rim[i] - 2 : rim[i] + 1];
            for (int corner : new int[] {b, a, n + a, b, n + a, n + b}) {
                triangles[at++] = corner;
            }
        }
        return new TriangleMesh(positions, triangles);
    }

    /** Vertex normals averaged over neighbours, so that the inner face does not fold where the sheet bends. */
    private static double[] smoothNormals(TriangleMesh middle) {
        double[] normals = MeshMeasure.vertexNormals(middle);
        int[] face = middle.triangles();
        int n = middle.vertexCount();
        for (int pass = 0; pass < NORMAL_PASSES; pass++) {
            double[] sum = new double[3 * n];
            for (int c = 0; c < face.length; c++) {
                int next = face[c % 3 == 2 ? c - 2 : c + 1];
                int other = face[c % 3 == 0 ? c + 2 : c - 1];
                for (int k = 0; k < 3; k++) {
                    sum[3 * face[c] + k] += normals[3 * next + k] + normals[3 * other + k];
                }
            }
            for (int v = 0; v < n; v++) {
                double[] s = Vectors.normalize(Vectors.of(sum[3 * v], sum[3 * v + 1], sum[3 * v + 2]));
                double[] own = Vectors.of(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
                System.arraycopy(Vectors.normalize(Vectors.addScaled(own, s, 1)), 0, normals, 3 * v, 3);
            }
        }
        return normals;
    }
}
