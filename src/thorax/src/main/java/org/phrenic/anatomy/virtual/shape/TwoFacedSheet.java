package org.phrenic.anatomy.virtual.shape;

import java.util.Arrays;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * A closed sheet of two faces about a middle surface. Of n vertices, vertex i lies on the face toward the normals and
 * vertex i + n/2 is its partner on the other face.
 */
public final class TwoFacedSheet {
    /** Length over which normals are averaged, mm. */
    private static final double NORMAL_LENGTH_MM = 6.5;

    private static final int LEAST_PASSES = 5;

    private TwoFacedSheet() {}

    /**
     * Offsets a middle surface by half a thickness to either side and closes the border.
     *
     * @param middle open surface with one border
     * @param thicknessMm thickness of the sheet everywhere, mm
     */
    public static TriangleMesh of(TriangleMesh middle, double thicknessMm) {
        double[] thickness = new double[middle.vertexCount()];
        Arrays.fill(thickness, thicknessMm);
        return of(middle, MeshMeasure.vertexNormals(middle), NORMAL_LENGTH_MM, thickness, rim(middle));
    }

    /**
     * Offsets a middle surface by half a thickness to either side and closes the border.
     *
     * @param middle open surface with one border
     * @param normals unit normal of each vertex, three numbers each; they are averaged over neighbours, so that the
     *     inner face does not fold where the sheet bends
     * @param smoothing length over which normals are averaged, mm
     * @param thickness thickness at each vertex, mm
     * @param rim edges of the border, two vertices each, against the direction of their triangles
     */
    public static TriangleMesh of(
            TriangleMesh middle, double[] normals, double smoothing, double[] thickness, int[] rim) {
        int n = middle.vertexCount();
        double[] positions = new double[6 * n];
        double[][] smooth = smoothNormals(middle, normals, smoothing);
        for (int v = 0; v < n; v++) {
            double[] p = Vectors.of(middle.x(v), middle.y(v), middle.z(v));
            double half = thickness[v] / 2;
            System.arraycopy(Vectors.addScaled(p, smooth[v], half), 0, positions, 3 * v, 3);
            System.arraycopy(Vectors.addScaled(p, smooth[v], -half), 0, positions, 3 * (n + v), 3);
        }
        int[] face = middle.triangles();
        int[] triangles = new int[2 * face.length + 3 * rim.length];
        for (int t = 0; t < face.length; t += 3) {
            triangles[t] = face[t];
            triangles[t + 1] = face[t + 1];
            triangles[t + 2] = face[t + 2];
            triangles[face.length + t] = n + face[t];
            triangles[face.length + t + 1] = n + face[t + 2];
            triangles[face.length + t + 2] = n + face[t + 1];
        }
        int at = 2 * face.length;
        for (int i = 0; i < rim.length; i += 2) {
            int a = rim[i];
            int b = rim[i + 1];
            for (int corner : new int[] {a, b, n + b, a, n + b, n + a}) {
                triangles[at++] = corner;
            }
        }
        return new TriangleMesh(positions, triangles);
    }

    private static int[] rim(TriangleMesh middle) {
        int[] face = middle.triangles();
        MeshTopology topology = new MeshTopology(middle);
        int[] rim = new int[2 * face.length];
        int count = 0;
        for (int side = 0; side < face.length; side++) {
            if (topology.faceCount(topology.edgeOfSide()[side]) == 1) {
                rim[count++] = face[side % 3 == 2 ? side - 2 : side + 1];
                rim[count++] = face[side];
            }
        }
        return Arrays.copyOf(rim, count);
    }

    /**
     * Number of passes that average over a length, at least 5: on a coarse mesh fewer leave folds. Each pass moves half
     * of the weight by one edge.
     *
     * @param length root mean square distance over which values are averaged, mm
     * @param edge mean edge length, mm
     */
    public static int passesOver(double length, double edge) {
        return (int) Math.max(LEAST_PASSES, Math.round(2 * length * length / (edge * edge)));
    }

    private static double[][] smoothNormals(TriangleMesh middle, double[] given, double length) {
        int n = middle.vertexCount();
        double[][] normals = new double[n][];
        for (int v = 0; v < n; v++) {
            normals[v] = Arrays.copyOfRange(given, 3 * v, 3 * v + 3);
        }
        int[] face = middle.triangles();
        int passes = passesOver(length, MeshQuality.of(middle).meanEdgeMm());
        for (int pass = 0; pass < passes; pass++) {
            double[][] sums = new double[n][3];
            for (int t = 0; t < face.length; t += 3) {
                for (int k = 0; k < 3; k++) {
                    int v = face[t + k];
                    sums[v] = Vectors.addScaled(sums[v], normals[face[t + (k + 1) % 3]], 1);
                    sums[v] = Vectors.addScaled(sums[v], normals[face[t + (k + 2) % 3]], 1);
                }
            }
            for (int v = 0; v < n; v++) {
                normals[v] = Vectors.normalize(Vectors.addScaled(normals[v], Vectors.normalize(sums[v]), 1));
            }
        }
        return normals;
    }
}
