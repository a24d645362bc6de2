package org.phrenic.mesh;

/**
 * Cotangent weights of the edges of a surface, w = (cot α + cot β) / 2, with α and β the angles opposite an edge. They
 * are the finite element weights of the Laplacian with linear elements (Pinkall and Polthier 1993, doi
 * 10.1080/10586458.1993.10504266). Equilateral triangles have 1/√3; where opposite angles sum to more than 180 degrees
 * a weight is negative.
 */
public final class CotangentWeights {
    private CotangentWeights() {}

    /** Weight of each edge, in the order of the topology; an edge with one triangle has one term. */
    public static double[] of(TriangleMesh mesh, MeshTopology topology) {
        double[] weights = new double[topology.edgeCount()];
        double[] n = new double[3];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            addCotangents(mesh, i, topology.edgeOfSide(), n, weights);
        }
        return weights;
    }

    private static void addCotangents(TriangleMesh mesh, int triangle, int[] edges, double[] n, double[] weights) {
        double twiceArea = MeshMeasure.triangleCrossProduct(mesh, triangle, n);
        double[] p = mesh.positions();
        int[] t = mesh.triangles();
        int at = 3 * triangle;
        for (int corner = 0; corner < 3; corner++) {
            int edge = edges[at + (corner + 1) % 3];
            if (edge < 0 || twiceArea == 0) {
                continue;
            }
            int a = 3 * t[at + corner];
            int b = 3 * t[at + (corner + 1) % 3];
            int c = 3 * t[at + (corner + 2) % 3];
            double dot = (p[b] - p[a]) * (p[c] - p[a])
                    + (p[b + 1] - p[a + 1]) * (p[c + 1] - p[a + 1])
                    + (p[b + 2] - p[a + 2]) * (p[c + 2] - p[a + 2]);
            weights[edge] += 0.5 * dot / twiceArea;
        }
    }
}
