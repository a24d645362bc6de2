package org.phrenic.study.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.cage.RibEnds;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Dimensions of the rib cage: bounding box of all ribs in their current position, lengths of ribs (mean of both sides,
 * along the surface), and length of the sternum from end to end.
 */
final class CageDimensions implements SceneMeasure {
    private static final int LEVELS = 12;

    static final List<String> NAMES = names();

    private final int[] ribs;
    private final Map<String, Double> fixed = new TreeMap<>();

    CageDimensions(SceneGeometry view) {
        ribs = view.indicesOf(StructureKind.RIB);
        for (int level = 1; level <= LEVELS; level++) {
            int wanted = level;
            double sum = 0;
            int[] pair = view.indicesOf(
                    s -> s.kind() == StructureKind.RIB && s.level() == wanted && s.side() != Side.MIDLINE);
            for (int i : pair) {
                Surface s = view.surface(i);
                sum += RibEnds.find(s.rest(), s.side()).lengthMm();
            }
            if (pair.length > 0) {
                fixed.put(length(level), sum / pair.length);
            }
        }
        int[] sternum = view.indicesOf(StructureKind.STERNUM);
        if (sternum.length > 0) {
            fixed.put("sternum_length_mm", extent(view, sternum));
        }
    }

    private static List<String> names() {
        List<String> names = new ArrayList<>(
                List.of("cage_breadth_mm", "cage_depth_mm", "cage_height_mm", "cage_depth_over_breadth"));
        IntStream.rangeClosed(1, LEVELS).forEach(n -> names.add(length(n)));
        names.add("sternum_length_mm");
        return List.copyOf(names);
    }

    private static String length(int level) {
        return SceneGeometry.name("rib", level, "length_mm");
    }

    /** Distance between the highest and the lowest point, in the median plane. */
    private static double extent(SceneGeometry view, int[] parts) {
        double[] low = {0, 0, Double.POSITIVE_INFINITY};
        double[] high = {0, 0, Double.NEGATIVE_INFINITY};
        for (int part : parts) {
            double[] p = view.surface(part).rest().positions();
            for (int k = 0; k < p.length; k += 3) {
                low = p[k + 2] < low[2] ? new double[] {p[k], p[k + 1], p[k + 2]} : low;
                high = p[k + 2] > high[2] ? new double[] {p[k], p[k + 1], p[k + 2]} : high;
            }
        }
        double dy = high[1] - low[1];
        double dz = high[2] - low[2];
        return Math.sqrt(dy * dy + dz * dz);
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        values.putAll(fixed);
        if (ribs.length == 0) {
            return;
        }
        double[] low = new double[3];
        double[] high = new double[3];
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        for (int rib : ribs) {
            double[] p = view.positions(rib);
            for (int k = 0; k < p.length; k++) {
                low[k % 3] = Math.min(low[k % 3], p[k]);
                high[k % 3] = Math.max(high[k % 3], p[k]);
            }
        }
        values.put("cage_breadth_mm", high[0] - low[0]);
        values.put("cage_depth_mm", high[1] - low[1]);
        values.put("cage_height_mm", high[2] - low[2]);
        values.put("cage_depth_over_breadth", (high[1] - low[1]) / (high[0] - low[0]));
    }
}
