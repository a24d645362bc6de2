package org.phrenic.study.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Skeletal level of the domes on a frontal image. Levels are interpolated between the middles of bones and grow
 * downward. The first scale is vertebral bodies (8 for the middle of T8, 13 for L1). The second is the front halves of
 * the ribs in the midclavicular line (5.5 for the fifth intercostal space).
 */
final class DomeLevelMeasure implements SceneMeasure {
    static final List<String> NAMES = List.of(("dome_right_vertebra dome_left_vertebra central_tendon_vertebra"
                    + " dome_right_rib dome_left_rib dome_right_above_left_mm")
            .split(" "));

    /** Depth of a vertebral body from its front, mm. */
    private static final double BODY_MM = 25;

    private static final double MIDLINE_MM = 20;
    /** Distance from the midline within which the heart hides the dome on a frontal image, mm. */
    private static final double HEART_MM = 45;
    /** Distance of the midclavicular line from the middle, as a fraction of the sheet's half width. */
    private static final double MIDCLAVICULAR = 0.55;
    /** Half width of the band around the midclavicular line in which a rib is measured, mm. */
    private static final double BAND_MM = 10;

    /** Number of a level and the height of its middle, mm. */
    private record Level(double number, double z) {}

    private final int sheet;
    private final double middle;
    private final double clavicular;
    private final List<Level> vertebrae = new ArrayList<>();
    private final int[] ribs;

    DomeLevelMeasure(SceneGeometry view) {
        sheet = view.diaphragm();
        double[] box = view.surface(sheet).rest().bounds();
        middle = 0.5 * (box[0] + box[3]);
        clavicular = 0.5 * MIDCLAVICULAR * (box[3] - box[0]);
        for (int i : view.indicesOf(StructureKind.VERTEBRA)) {
            Surface s = view.surface(i);
            vertebrae.add(new Level(s.level(), bodyMiddle(s)));
        }
        ribs = view.indicesOf(StructureKind.RIB);
    }

    private static double bodyMiddle(Surface s) {
        double front = s.rest().bounds()[1];
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < s.rest().vertexCount(); i++) {
            if (s.rest().y(i) < front + BODY_MM) {
                low = Math.min(low, s.rest().z(i));
                high = Math.max(high, s.rest().z(i));
            }
        }
        return 0.5 * (low + high);
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        double[] p = view.positions(sheet);
        double[] right = domeTop(p, -1);
        double[] left = domeTop(p, 1);
        values.put("dome_right_vertebra", interpolatedLevel(vertebrae, right[2]));
        values.put("dome_left_vertebra", interpolatedLevel(vertebrae, left[2]));
        values.put(
                "central_tendon_vertebra",
                interpolatedLevel(
                        vertebrae, centralTendonHeight(p, view.surface(sheet).tendon())));
        values.put("dome_right_rib", interpolatedLevel(ribLevels(view, Side.RIGHT, middle - clavicular), right[2]));
        values.put("dome_left_rib", interpolatedLevel(ribLevels(view, Side.LEFT, middle + clavicular), left[2]));
        values.put("dome_right_above_left_mm", right[2] - left[2]);
    }

    /** Highest point of the dome on one side; NaN for a sheet that does not reach beyond the heart. */
    private double[] domeTop(double[] p, int sign) {
        int best = -1;
        for (int k = 0; k < p.length; k += 3) {
            if (sign * (p[k] - middle) > HEART_MM && (best < 0 || p[k + 2] > p[best + 2])) {
                best = k;
            }
        }
        return best < 0
                ? new double[] {Double.NaN, Double.NaN, Double.NaN}
                : new double[] {p[best], p[best + 1], p[best + 2]};
    }

    private double centralTendonHeight(double[] p, boolean[] tendon) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < tendon.length; i++) {
            if (tendon[i] && Math.abs(p[3 * i] - middle) < MIDLINE_MM) {
                sum += p[3 * i + 2];
                count++;
            }
        }
        return sum / count;
    }

    /** Heights at which the front halves of one side's ribs cross a sagittal plane. */
    private List<Level> ribLevels(SceneGeometry view, Side side, double x) {
        List<Level> levels = new ArrayList<>();
        for (int r : ribs) {
            if (view.surface(r).side() == side) {
                double[] p = view.positions(r);
                double turn = p[SceneGeometry.mostLateral(p, side.sign()) + 1];
                double sum = 0;
                int count = 0;
                for (int k = 0; k < p.length; k += 3) {
                    if (p[k + 1] < turn && Math.abs(p[k] - x) < BAND_MM) {
                        sum += p[k + 2];
                        count++;
                    }
                }
                if (count > 0) {
                    levels.add(new Level(view.surface(r).level(), sum / count));
                }
            }
        }
        return levels;
    }

    /** Level at a height, by linear interpolation; NaN outside the levels. */
    private static double interpolatedLevel(List<Level> levels, double z) {
        Level above = null;
        Level below = null;
        for (Level level : levels) {
            if (level.z >= z && (above == null || level.z < above.z)) {
                above = level;
            }
            if (level.z < z && (below == null || level.z > below.z)) {
                below = level;
            }
        }
        if (above == null || below == null) {
            return Double.NaN;
        }
        return above.number + (below.number - above.number) * (above.z - z) / (above.z - below.z);
    }
}
