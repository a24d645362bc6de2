package org.phrenic.model.organ;

import org.phrenic.anatomy.Diaphragm;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * Strain that contracting muscle asks of the springs of a sheet, as a share of the activation: it shortens by 7/8 along
 * the fibres f and widens by 1/8 across them in the sheet with normal n, E = f f - 1/8 (I - n n). A spring along d
 * shortens by d·E d / |d|². Springs that all ask for one strain deform the sheet alike on every mesh. Held at their
 * length, they pull across the fibres with 1/5 of the force along them. In the tendon E is 0.
 */
final class MuscleStrain {
    /** Share by which free muscle widens across its fibres while it shortens along them by one minus this. */
    private static final double ACROSS = 0.125;

    /** Entries of a symmetric tensor: row and column of xx, yy, zz, xy, xz, yz. */
    private static final int[][] ENTRIES = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

    private final Diaphragm diaphragm;
    private final double[] positions;
    /** Mean of E over the triangles about each vertex, weighted by area. */
    private final double[][] atVertex;

    MuscleStrain(Diaphragm diaphragm) {
        this.diaphragm = diaphragm;
        TriangleMesh sheet = diaphragm.sheet();
        positions = sheet.positions();
        atVertex = new double[sheet.vertexCount()][ENTRIES.length];
        double[] area = new double[sheet.vertexCount()];
        int[] corners = sheet.triangles();
        double[] normal = new double[3];
        for (int t = 0; t < sheet.triangleCount(); t++) {
            double twice = MeshMeasure.triangleCrossProduct(sheet, t, normal);
            if (twice == 0) {
                continue;
            }
            double[] strain = strain(t, normal, twice);
            for (int k = 3 * t; k < 3 * t + 3; k++) {
                area[corners[k]] += twice;
                for (int i = 0; i < ENTRIES.length; i++) {
                    atVertex[corners[k]][i] += strain[i];
                }
            }
        }
        for (int v = 0; v < area.length; v++) {
            for (int i = 0; area[v] > 0 && i < ENTRIES.length; i++) {
                atVertex[v][i] /= area[v];
            }
        }
    }

    /** E of a triangle, times twice its area. */
    private double[] strain(int triangle, double[] normal, double twice) {
        double[] fibre = diaphragm.fibreDirections();
        double[] out = new double[ENTRIES.length];
        if (!isMuscle(fibre, triangle)) {
            return out;
        }
        for (int i = 0; i < out.length; i++) {
            int row = ENTRIES[i][0];
            int column = ENTRIES[i][1];
            double plane = (row == column ? 1 : 0) - normal[row] * normal[column] / (twice * twice);
            out[i] = twice * (fibre[3 * triangle + row] * fibre[3 * triangle + column] - ACROSS * plane);
        }
        return out;
    }

    private static boolean isMuscle(double[] fibre, int triangle) {
        return fibre[3 * triangle] != 0 || fibre[3 * triangle + 1] != 0 || fibre[3 * triangle + 2] != 0;
    }

    /** Shortening of an edge of the sheet: the mean of what its triangles ask for. */
    double alongEdge(int edge) {
        MeshTopology topology = diaphragm.topology();
        double[] fibre = diaphragm.fibreDirections();
        int a = topology.edges()[2 * edge];
        int b = topology.edges()[2 * edge + 1];
        double sum = 0;
        int sides = 0;
        for (int side = 0; side < 2; side++) {
            int triangle = topology.face(edge, side);
            if (triangle >= 0) {
                sum += inTriangle(positions, a, b, fibre, triangle);
                sides++;
            }
        }
        return sum / sides;
    }

    /** Shortening of a spring across the sheet, by the mean of E at its ends. */
    double alongStrut(int a, int b) {
        double[] d = new double[3];
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            d[axis] = positions[3 * b + axis] - positions[3 * a + axis];
            squared += d[axis] * d[axis];
        }
        double sum = 0;
        for (int i = 0; i < ENTRIES.length; i++) {
            int row = ENTRIES[i][0];
            int column = ENTRIES[i][1];
            double twofold = row == column ? 0.5 : 1;
            sum += twofold * (atVertex[a][i] + atVertex[b][i]) * d[row] * d[column];
        }
        return sum / squared;
    }

    /** Shortening of an edge by one of its triangles: cos² θ - 1/8, θ the angle between edge and fibres. */
    static double inTriangle(double[] p, int a, int b, double[] fibre, int triangle) {
        double dot = 0;
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = p[3 * b + axis] - p[3 * a + axis];
            dot += d * fibre[3 * triangle + axis];
            squared += d * d;
        }
        return isMuscle(fibre, triangle) ? dot * dot / squared - ACROSS : 0;
    }
}
