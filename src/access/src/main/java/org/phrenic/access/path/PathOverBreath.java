package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.TargetMotion;
import org.phrenic.document.OrderedValues;
import org.phrenic.simulation.observe.Surface;

/**
 * Analysis of a path over one breath. At each moment the path runs from the same skin point to the current position of
 * the target.
 *
 * @param analyses analysis of the path at each moment
 * @param margins margin to the avoided zones at each moment
 * @param marginsFrom display name of the structure that the margin is measured from at each moment; empty if none is in
 *     range
 * @param motion motion of the target
 * @param needle needle that the path is for
 */
public record PathOverBreath(
        List<BreathMoment> cycle,
        List<PathAnalysis> analyses,
        List<PathAnalyzer.Margin> margins,
        List<String> marginsFrom,
        TargetMotion motion,
        Needle needle,
        Set<NoGoZone> avoided) {
    /**
     * Analyses the path at each moment. Afterwards the anatomy is at the last moment.
     *
     * @param entryRest entry point on the skin at end-expiration
     * @throws org.phrenic.file.BadInputException if the entry point is not on the skin
     */
    public static PathOverBreath of(
            MovingAnatomy anatomy,
            List<BreathMoment> cycle,
            double[] entryRest,
            TargetLesion target,
            Needle needle,
            Set<NoGoZone> avoided) {
        SkinPoint entry = SkinPoint.atRest(anatomy.skin(), entryRest);
        LiverTissue tissue = new LiverTissue(anatomy);
        LiverTissue.Point centre = tissue.pointAtRest(target.restMm());
        PathAnalyzer analyzer = new PathAnalyzer(anatomy, needle);
        List<PathAnalysis> analyses = new ArrayList<>();
        List<double[]> targets = new ArrayList<>();
        List<PathAnalyzer.Margin> margins = new ArrayList<>();
        List<String> marginsFrom = new ArrayList<>();
        for (BreathMoment moment : cycle) {
            anatomy.update(moment.frame());
            double[] end = tissue.position(centre);
            targets.add(end);
            analyses.add(analyzer.analyze(entry.current(), end));
            PathAnalyzer.Margin margin = analyzer.margin(entry.current(), end, avoided);
            margins.add(margin);
            marginsFrom.add(anatomy.labelOf(margin.nearest()));
        }
        return new PathOverBreath(cycle, analyses, margins, marginsFrom, new TargetMotion(targets), needle, avoided);
    }

    /** Why the path is not free at a moment; empty if it is. */
    public List<String> reasons(int moment) {
        return analyses.get(moment).reasons(avoided, needle);
    }

    /** Whether the path is free at a moment. */
    public boolean isFree(int moment) {
        return reasons(moment).isEmpty();
    }

    /** Number of moments at which the path is free. */
    public int freeMoments() {
        return (int) IntStream.range(0, analyses.size()).filter(this::isFree).count();
    }

    /** Whether a margin at any moment is measured from a structure, or from the vessels below it. */
    public boolean isMeasuredFrom(Surface structure) {
        String name = structure.name();
        return margins.stream()
                .map(PathAnalyzer.Margin::nearest)
                .anyMatch(from -> from.equals(name) || from.equals(MovingAnatomy.VESSELS_PREFIX + name));
    }

    public Map<String, Object> toMap() {
        List<OrderedValues> moments =
                IntStream.range(0, analyses.size()).mapToObj(this::momentMap).toList();
        OrderedValues map = new OrderedValues().with("moments", analyses.size());
        BreathCycle.limits(cycle).ifPresent(limits -> map.put("limits", limits));
        return map.with("free_moments", freeMoments())
                .with("target_moves_mm", motion.excursionMm())
                .with("target_range_lr_ap_si_mm", motion.rangeMm())
                .with("at_end_expiration", analyses.get(0).toMap())
                .with("over_the_breath", moments);
    }

    private OrderedValues momentMap(int m) {
        PathAnalysis analysis = analyses.get(m);
        return new OrderedValues()
                .with("time_s", cycle.get(m).timeS())
                .with("breathing", cycle.get(m).label().label())
                .with("free", isFree(m))
                .with("margin_mm", margins.get(m).mm())
                .with("length_mm", analysis.lengthMm())
                .with("reasons", reasons(m))
                .with(
                        "crosses",
                        analysis.crossings().stream().map(Crossing::name).toList());
    }
}
