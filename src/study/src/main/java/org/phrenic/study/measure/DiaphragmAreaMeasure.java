package org.phrenic.study.measure;

import java.util.List;
import java.util.Map;
import org.phrenic.engine.math.Triangles;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Areas of the diaphragm's thoracic face and of its tendon, whose border crosses triangles, and the volume swept
 * downward by the face since rest. The volume is -∫ u·n dA, where u is the displacement and n dA the mean of the area
 * vectors at rest and in the current position.
 */
final class DiaphragmAreaMeasure implements SceneMeasure {
    static final List<String> NAMES =
            List.of("diaphragm_area_cm2", "tendon_area_cm2", "tendon_share_percent", "diaphragm_swept_ml");

    private final int sheet;
    private final boolean[] thoracic;

    DiaphragmAreaMeasure(SceneGeometry view) {
        sheet = view.diaphragm();
        thoracic = view.thoracicTriangles();
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        Surface s = view.surface(sheet);
        int[] t = s.rest().triangles();
        double[] rest = s.rest().positions();
        double[] now = view.positions(sheet);
        double area = 0;
        double ofTendon = 0;
        double swept = 0;
        double[] then = new double[3];
        double[] normal = new double[3];
        for (int i = 0; i < t.length; i += 3) {
            if (!thoracic[i / 3]) {
                continue;
            }
            Triangles.cross(rest, 3 * t[i], 3 * t[i + 1], 3 * t[i + 2], then);
            double size = 0.5 * Triangles.cross(now, 3 * t[i], 3 * t[i + 1], 3 * t[i + 2], normal);
            area += size;
            ofTendon += view.sheet().tendonArea(i / 3, size);
            for (int axis = 0; axis < 3; axis++) {
                double moved = 0;
                for (int c = 0; c < 3; c++) {
                    moved += (now[3 * t[i + c] + axis] - rest[3 * t[i + c] + axis]) / 3;
                }
                swept -= 0.25 * moved * (then[axis] + normal[axis]);
            }
        }
        values.put("diaphragm_area_cm2", area / 100);
        values.put("tendon_area_cm2", ofTendon / 100);
        values.put("tendon_share_percent", 100 * ofTendon / area);
        values.put("diaphragm_swept_ml", swept / 1000);
    }
}
