package org.phrenic.study.measure;

import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Motion of the liver's top and lower edge (mean of its highest and lowest fifth, up positive), and pitch of the
 * sternum. The pitch is the rotation of the line from its lowest to its highest fifth, positive if the lower end moves
 * forward.
 */
final class LiverSternumMeasure implements SceneMeasure {
    static final List<String> NAMES = List.of("liver_top_mm", "liver_edge_mm", "sternum_pitch_deg");

    private static final double FIFTH = 0.2;

    private final int[] livers;
    private final int[] sternum;

    LiverSternumMeasure(SceneGeometry view) {
        livers = view.indicesOf(StructureKind.LIVER);
        sternum = view.indicesOf(
                s -> s.kind() == StructureKind.STERNUM && !s.name().contains("xiphoid"));
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        if (livers.length > 0) {
            values.put(
                    "liver_top_mm",
                    meanOfFifth(view, livers, true, true)[2] - meanOfFifth(view, livers, true, false)[2]);
            values.put(
                    "liver_edge_mm",
                    meanOfFifth(view, livers, false, true)[2] - meanOfFifth(view, livers, false, false)[2]);
        }
        if (sternum.length > 0) {
            values.put("sternum_pitch_deg", pitchDegrees(view, true) - pitchDegrees(view, false));
        }
    }

    private double pitchDegrees(SceneGeometry view, boolean moved) {
        double[] top = meanOfFifth(view, sternum, true, moved);
        double[] foot = meanOfFifth(view, sternum, false, moved);
        return StrictMath.toDegrees(StrictMath.atan2(top[1] - foot[1], top[2] - foot[2]));
    }

    /** Mean of the points that are in the highest or lowest fifth at rest, at rest or in the current position. */
    private static double[] meanOfFifth(SceneGeometry view, int[] parts, boolean top, boolean moved) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int part : parts) {
            double[] box = view.surface(part).rest().bounds();
            low = Math.min(low, box[2]);
            high = Math.max(high, box[5]);
        }
        double limit = top ? high - FIFTH * (high - low) : low + FIFTH * (high - low);
        double[] sum = new double[3];
        int count = 0;
        for (int part : parts) {
            Surface s = view.surface(part);
            double[] rest = s.rest().positions();
            double[] p = moved ? view.positions(part) : rest;
            for (int k = 0; k < p.length; k += 3) {
                if (top ? rest[k + 2] >= limit : rest[k + 2] <= limit) {
                    for (int axis = 0; axis < 3; axis++) {
                        sum[axis] += p[k + axis];
                    }
                    count++;
                }
            }
        }
        return new double[] {sum[0] / count, sum[1] / count, sum[2] / count};
    }
}
