package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.TargetMotion;

/**
 * One path over a whole breath: at each moment from the same point of the skin to where the target is then.
 *
 * @param cycle the moments
 * @param analyses what the path meets at each
 * @param marginsMm distance from what is to be avoided at each; 0 where it is touched
 * @param targets where the target's middle is at each
 * @param avoided what is to be avoided
 */
public record PathOverBreath(
        List<BreathMoment> cycle,
        List<PathAnalysis> analyses,
        double[] marginsMm,
        List<double[]> targets,
        Set<NoGoZone> avoided) {
    /**
     * Looks at each moment; afterwards the scene shows the last.
     *
     * @param entryRest on the skin at end-expiration
     * @throws org.phrenic.format.BadInputException with one sentence, if it is not on the skin
     */
    public static PathOverBreath of(
            MovingAnatomy scene,
            List<BreathMoment> cycle,
            double[] entryRest,
            TargetLesion target,
            Needle needle,
            Set<NoGoZone> avoided) {
        SkinPoint entry = SkinPoint.atRest(scene.skin(), entryRest);
        LiverTissue tissue = new LiverTissue(scene);
        LiverTissue.Point middle = tissue.pointAtRest(target.restMm());
        PathAnalyzer reader = new PathAnalyzer(scene, needle);
        List<PathAnalysis> readings = new ArrayList<>();
        List<double[]> targets = new ArrayList<>();
        double[] margins = new double[cycle.size()];
        for (int m = 0; m < margins.length; m++) {
            scene.update(cycle.get(m).frame());
            double[] end = tissue.position(middle);
            targets.add(end);
            readings.add(reader.analyze(entry.current(), end));
            margins[m] = reader.margin(entry.current(), end, avoided);
        }
        return new PathOverBreath(cycle, readings, margins, targets, avoided);
    }

    /** Whether the path may be taken at a moment. */
    public boolean isFree(int moment) {
        return analyses.get(moment).reasons(avoided).isEmpty();
    }

    /** At how many moments it may be taken. */
    public int freeMoments() {
        int count = 0;
        for (int m = 0; m < analyses.size(); m++) {
            count += isFree(m) ? 1 : 0;
        }
        return count;
    }

    /** How the target moves. */
    public TargetMotion motion() {
        return new TargetMotion(targets);
    }

    /** Closest approach to each structure over the breath, by name. */
    public Map<String, Approach> closest() {
        Map<String, Approach> closest = new TreeMap<>();
        analyses.forEach(r -> r.approaches()
                .forEach(a -> closest.merge(a.name(), a, (x, y) -> y.distanceMm() < x.distanceMm() ? y : x)));
        return closest;
    }

    /** Plain values for a report. */
    public Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("moments", analyses.size());
        map.put("free_moments", freeMoments());
        map.put("target_moves_mm", motion().excursionMm());
        map.put("target_range_lr_ap_si_mm", motion().rangeMm());
        map.put("at_end_expiration", analyses.get(0).toMap());
        List<Map<String, Object>> rows = new ArrayList<>();
        for (int m = 0; m < analyses.size(); m++) {
            Map<String, Object> row = new LinkedHashMap<>();
            row.put("time_s", cycle.get(m).timeS());
            row.put("breathing", cycle.get(m).label().name().toLowerCase(Locale.ROOT));
            row.put("free", isFree(m));
            row.put("margin_mm", marginsMm[m]);
            row.put("length_mm", analyses.get(m).lengthMm());
            row.put("reasons", analyses.get(m).reasons(avoided));
            row.put(
                    "crosses",
                    analyses.get(m).crossings().stream().map(Crossing::name).toList());
            rows.add(row);
        }
        map.put("over_the_breath", rows);
        return map;
    }
}
