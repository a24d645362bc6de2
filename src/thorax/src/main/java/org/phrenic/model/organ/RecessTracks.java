package org.phrenic.model.organ;

import java.util.Arrays;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Polylines on the thoracic face of the diaphragm at rest, from given points to the insertion, with a point spacing of
 * {@value #SPACING_MM} mm. The lung border slides along them as the costodiaphragmatic recess opens. They depend on the
 * body alone, so they can be computed before the particle system exists.
 *
 * <p>The tracks follow the muscle fibres, which cover the sheet without crossing. Shortest paths to the insertion do
 * not: on a scanned sheet the paths of neighbouring points diverged around the flank, and the base of the lung was
 * pulled through the dome between them. In the tendon, which has no fibres, the tracks follow the shortest path.
 */
public final class RecessTracks {
    static final double SPACING_MM = 6;
    /** Longest step along the face: the spacing plus a margin for rounding. */
    private static final double MAX_STEP_MM = 1.01 * SPACING_MM;
    /** A shorter step means that the track has reached the border. */
    private static final double MIN_STEP_MM = 0.3 * SPACING_MM;

    private static final int MAX_POINTS = 48;

    /** Index of the first point of each track, followed by the total number of points. */
    final int[] start;
    /** For each point: three vertices of the sheet and their weights. */
    int[] corner;

    double[] weight;

    /** @param points start points of the tracks, three numbers each, mm */
    public RecessTracks(ThoracicFace face, double[] points) {
        Diaphragm diaphragm = face.diaphragm;
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int n = points.length / 3;
        start = new int[n + 1];
        corner = new int[3 * n * MAX_POINTS];
        weight = new double[3 * n * MAX_POINTS];
        double[] down = new double[3];
        int count = 0;
        for (int i = 0; i < n; i++) {
            start[i] = count;
            double x = points[3 * i];
            double y = points[3 * i + 1];
            double z = points[3 * i + 2];
            double reach = Double.POSITIVE_INFINITY;
            double fromX = Double.NaN;
            double fromY = Double.NaN;
            double fromZ = Double.NaN;
            for (int k = 0; k < MAX_POINTS; k++) {
                face.closest(x, y, z, reach, hit);
                if (squared(hit.x - fromX, hit.y - fromY, hit.z - fromZ) < MIN_STEP_MM * MIN_STEP_MM) {
                    break;
                }
                weight[3 * count] = hit.weightA;
                weight[3 * count + 1] = hit.weightB;
                weight[3 * count + 2] = hit.weightC;
                double toInsertion = 0;
                for (int c = 0; c < 3; c++) {
                    corner[3 * count + c] = face.vertex(hit, c);
                    toInsertion += weight[3 * count + c] * diaphragm.distanceFromInsertion(corner[3 * count + c]);
                }
                count++;
                if (toInsertion < SPACING_MM) {
                    break;
                }
                alongFibre(diaphragm, face.triangle(hit), down);
                fromX = hit.x;
                fromY = hit.y;
                fromZ = hit.z;
                x = fromX + SPACING_MM * down[0];
                y = fromY + SPACING_MM * down[1];
                z = fromZ + SPACING_MM * down[2];
                // Limiting the search radius to the step length shortens the search.
                reach = MAX_STEP_MM;
            }
        }
        start[n] = count;
        corner = Arrays.copyOf(corner, 3 * count);
        weight = Arrays.copyOf(weight, 3 * count);
    }

    private static double squared(double x, double y, double z) {
        return x * x + y * y + z * z;
    }

    /** Unit vector in a triangle along the fibres toward the insertion. */
    private static void alongFibre(Diaphragm diaphragm, int triangle, double[] out) {
        double[] fibre = diaphragm.fibreDirections();
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = -fibre[3 * triangle + axis];
        }
        if (squared(out[0], out[1], out[2]) == 0) {
            shortest(diaphragm, triangle, out);
        }
    }

    /** Unit vector in a triangle of steepest descent of the distance to the insertion. */
    private static void shortest(Diaphragm diaphragm, int triangle, double[] out) {
        double[] p = diaphragm.sheet().positions();
        int[] t = diaphragm.sheet().triangles();
        int a = t[3 * triangle];
        int b = t[3 * triangle + 1];
        int c = t[3 * triangle + 2];
        double db = diaphragm.distanceFromInsertion(b) - diaphragm.distanceFromInsertion(a);
        double dc = diaphragm.distanceFromInsertion(c) - diaphragm.distanceFromInsertion(a);
        double uu = 0;
        double uv = 0;
        double vv = 0;
        for (int axis = 0; axis < 3; axis++) {
            double u = p[3 * b + axis] - p[3 * a + axis];
            double v = p[3 * c + axis] - p[3 * a + axis];
            uu += u * u;
            uv += u * v;
            vv += v * v;
        }
        double det = Math.max(uu * vv - uv * uv, Double.MIN_NORMAL);
        double alongU = (vv * db - uv * dc) / det;
        double alongV = (uu * dc - uv * db) / det;
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = -alongU * (p[3 * b + axis] - p[3 * a + axis]) - alongV * (p[3 * c + axis] - p[3 * a + axis]);
        }
        double length = Math.max(Math.sqrt(squared(out[0], out[1], out[2])), Double.MIN_NORMAL);
        for (int axis = 0; axis < 3; axis++) {
            out[axis] /= length;
        }
    }
}
