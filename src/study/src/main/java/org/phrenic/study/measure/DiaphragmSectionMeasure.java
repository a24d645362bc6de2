package org.phrenic.study.measure;

import java.util.List;
import java.util.Map;
import org.phrenic.simulation.observe.Frame;

/**
 * Length of the diaphragm in coronal and sagittal sections. The planes are fixed in the frame of the body, as in a
 * scanner in which it lies straight. At rest they pass through the points of dome measurement, half way out to the side
 * and a third of the way back. The length is half of the sheet's section, which contains both faces.
 */
final class DiaphragmSectionMeasure implements SceneMeasure {
    static final List<String> NAMES =
            List.of("coronal_right_mm", "coronal_left_mm", "sagittal_right_mm", "sagittal_left_mm");

    private static final double LATERAL_SHARE = 0.5;
    private static final double POSTERIOR_SHARE = 0.33;

    private final int sheet;
    private final int[] triangles;
    private final double middle;
    private final double[] sagittal;
    private final double coronal;

    DiaphragmSectionMeasure(SceneGeometry view) {
        sheet = view.diaphragm();
        triangles = view.surface(sheet).rest().triangles();
        double[] box = view.surface(sheet).rest().bounds();
        middle = 0.5 * (box[0] + box[3]);
        double out = LATERAL_SHARE * 0.5 * (box[3] - box[0]);
        sagittal = new double[] {middle - out, middle + out};
        coronal = 0.5 * (box[1] + box[4]) + POSTERIOR_SHARE * 0.5 * (box[4] - box[1]);
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        double[] p = view.positions(sheet);
        for (int side = 0; side < 2; side++) {
            String name = side == 0 ? "right_mm" : "left_mm";
            values.put("coronal_" + name, sectionLength(p, 1, coronal, side));
            values.put("sagittal_" + name, sectionLength(p, 0, sagittal[side], side));
        }
    }

    /** Section length for the plane {@code p[axis] = at}, on one side of the middle, mm. */
    private double sectionLength(double[] p, int axis, double at, int side) {
        double sum = 0;
        double[] ends = new double[6];
        for (int t = 0; t < triangles.length; t += 3) {
            int found = 0;
            for (int c = 0; c < 3; c++) {
                int a = 3 * triangles[t + c];
                int b = 3 * triangles[t + (c + 1) % 3];
                double da = p[a + axis] - at;
                double db = p[b + axis] - at;
                if (da < 0 != db < 0) {
                    double w = da / (da - db);
                    for (int k = 0; k < 3; k++) {
                        ends[3 * found + k] = p[a + k] + w * (p[b + k] - p[a + k]);
                    }
                    found++;
                }
            }
            if (found == 2 && (0.5 * (ends[0] + ends[3]) > middle ? 1 : 0) == side) {
                double dx = ends[3] - ends[0];
                double dy = ends[4] - ends[1];
                double dz = ends[5] - ends[2];
                sum += 0.5 * Math.sqrt(dx * dx + dy * dy + dz * dz);
            }
        }
        return sum;
    }
}
