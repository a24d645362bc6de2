package org.phrenic.anatomy;

import java.util.Arrays;
import org.phrenic.engine.math.ArgSort;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * The central tendon: three leaflets on the roof of the sheet, a right one (the largest), a left one (the narrowest)
 * and a median one in front of them, fused with the pericardium. Each is an ellipse in the horizontal plan of the
 * sheet, in units of the sheet's half-width and half-depth. They grow together until the tendon has its fraction of the
 * area.
 */
final class CentralTendon {
    /** Centre u (left), centre v (posterior), radius in u and radius in v of the right, left and median leaflet. */
    private static final double[][] LEAFLETS = {
        {-0.42, 0.12, 0.34, 0.44}, {0.45, 0.14, 0.30, 0.42}, {0.0, -0.26, 0.40, 0.30},
    };

    /** A vertex belongs to the roof if the cosine between its normal and the vertical exceeds this. */
    private static final double MIN_ROOF_COSINE = 0.25;

    /**
     * A roof vertex also lies above this fraction of the sheet's height. This excludes crura, which hang far down, and
     * the level floor behind them.
     */
    private static final double MIN_HEIGHT_SHARE = 0.65;

    private CentralTendon() {}

    /**
     * Marks the vertices of the tendon.
     *
     * @param sheet closed sheet, LPS, mm
     * @param share fraction of the sheet's area, 0 to 1
     */
    static boolean[] of(TriangleMesh sheet, double share) {
        double[] box = sheet.bounds();
        double[] normals = MeshMeasure.vertexNormals(sheet);
        double[] areas = MeshMeasure.vertexAreas(sheet);
        int n = sheet.vertexCount();
        double[] level = new double[n];
        long[] key = new long[n];
        for (int i = 0; i < n; i++) {
            double u = (sheet.x(i) - 0.5 * (box[0] + box[3])) / (0.5 * (box[3] - box[0]));
            double v = (sheet.y(i) - 0.5 * (box[1] + box[4])) / (0.5 * (box[4] - box[1]));
            boolean upper = sheet.z(i) > box[2] + MIN_HEIGHT_SHARE * (box[5] - box[2]);
            level[i] = upper && Math.abs(normals[3 * i + 2]) > MIN_ROOF_COSINE
                    ? leafletLevel(u, v)
                    : Double.POSITIVE_INFINITY;
            // The bit patterns of non-negative doubles sort as their values.
            key[i] = Double.doubleToRawLongBits(level[i]);
        }
        int[] order = ArgSort.of(key);
        double wanted = share * Arrays.stream(areas).sum();
        boolean[] tendon = new boolean[n];
        double sum = 0;
        for (int i = 0; i < n && sum < wanted && level[order[i]] < Double.POSITIVE_INFINITY; i++) {
            tendon[order[i]] = true;
            sum += areas[order[i]];
        }
        return tendon;
    }

    private static double leafletLevel(double u, double v) {
        double least = Double.POSITIVE_INFINITY;
        for (double[] leaf : LEAFLETS) {
            double a = (u - leaf[0]) / leaf[2];
            double b = (v - leaf[1]) / leaf[3];
            least = Math.min(least, a * a + b * b);
        }
        return least;
    }
}
