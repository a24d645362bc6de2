package org.phrenic.anatomy;

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

    /** Weight of the height relative to the leaflets' radii, whose slopes are then alike. */
    private static final double HEIGHT_WEIGHT = 4;

    private static final int BISECTIONS = 50;

    private CentralTendon() {}

    /**
     * A field on the vertices that is negative in the tendon. Its zero line is the tendon's border, which crosses edges
     * where the linear interpolation of the field is 0, so the area within it does not depend on where vertices lie.
     *
     * @param sheet closed sheet, LPS, mm
     * @param share fraction of the sheet's area, 0 to 1
     */
    static double[] field(TriangleMesh sheet, double share) {
        double[] box = sheet.bounds();
        double[] normals = MeshMeasure.vertexNormals(sheet);
        int n = sheet.vertexCount();
        double[] radius = new double[n];
        double[] roof = new double[n];
        double most = 0;
        for (int i = 0; i < n; i++) {
            double u = (sheet.x(i) - 0.5 * (box[0] + box[3])) / (0.5 * (box[3] - box[0]));
            double v = (sheet.y(i) - 0.5 * (box[1] + box[4])) / (0.5 * (box[4] - box[1]));
            double height = (sheet.z(i) - box[2]) / (box[5] - box[2]);
            radius[i] = Math.sqrt(leafletLevel(u, v));
            roof[i] = Math.max(
                    HEIGHT_WEIGHT * (MIN_HEIGHT_SHARE - height), MIN_ROOF_COSINE - Math.abs(normals[3 * i + 2]));
            most = Math.max(most, radius[i]);
        }
        double[] areas = new double[sheet.triangleCount()];
        double[] normal = new double[3];
        double wanted = 0;
        for (int t = 0; t < areas.length; t++) {
            areas[t] = 0.5 * MeshMeasure.triangleCrossProduct(sheet, t, normal);
            wanted += share * areas[t];
        }
        double low = 0;
        double high = most;
        double[] field = new double[n];
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = 0.5 * (low + high);
            if (areaWithin(sheet, areas, fill(field, radius, roof, middle)) < wanted) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return fill(field, radius, roof, high);
    }

    private static double[] fill(double[] field, double[] radius, double[] roof, double limit) {
        for (int i = 0; i < field.length; i++) {
            field[i] = Math.max(radius[i] - limit, roof[i]);
        }
        return field;
    }

    /** Area in which a field, linear in each triangle, is negative. */
    private static double areaWithin(TriangleMesh sheet, double[] areas, double[] field) {
        int[] corner = sheet.triangles();
        double sum = 0;
        for (int t = 0; t < areas.length; t++) {
            sum += areaWithin(areas[t], field[corner[3 * t]], field[corner[3 * t + 1]], field[corner[3 * t + 2]]);
        }
        return sum;
    }

    /** Area in which a field, linear in a triangle of a given area with the values a, b and c, is negative. */
    static double areaWithin(double area, double a, double b, double c) {
        double least = Math.min(a, Math.min(b, c));
        double greatest = Math.max(a, Math.max(b, c));
        if (greatest < 0) {
            return area;
        }
        if (!(least < 0)) {
            return 0;
        }
        double middle = a + b + c - least - greatest;
        return middle < 0
                ? area * (1 - greatest * greatest / ((greatest - least) * (greatest - middle)))
                : area * least * least / ((middle - least) * (greatest - least));
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
