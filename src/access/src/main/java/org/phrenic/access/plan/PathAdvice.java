package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.access.AbsentObstacles;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.observe.Surface;

/**
 * Advice about a path over one breath, in clinical terms.
 *
 * @param reasons reasons against the path and when they apply, one line each; may be empty
 * @param margin margin to the avoided zones while the path is free; empty if it is never free
 * @param way length, intercostal space and angle of the path
 */
public record PathAdvice(Level level, String headline, List<String> reasons, String margin, String way) {
    /** Advice levels, displayed in green, amber and red. */
    public enum Level {
        FREE,
        CAREFUL,
        BARRED
    }

    /** This advice with a remark on what the body lacks; a free path is then one to be careful with. */
    public PathAdvice withRemark(String remark) {
        List<String> all = new ArrayList<>(reasons);
        all.add(remark);
        return new PathAdvice(level == Level.FREE ? Level.CAREFUL : level, headline, List.copyOf(all), margin, way);
    }

    /**
     * Advice on a path in a body, with remarks on what of the breathing is not recorded, on what the body lacks, and on
     * skin, liver and structures that a margin is measured from where its scan does not show them or shows a part.
     */
    public static PathAdvice of(PathOverBreath path, BodySurfaces body) {
        PathAdvice advice = of(path);
        List<String> names = body.surfaces().stream().map(Surface::name).toList();
        for (Optional<String> remark : List.of(BreathCycle.limits(path.cycle()), AbsentObstacles.sentence(names))) {
            advice = remark.map(advice::withRemark).orElse(advice);
        }
        String unseen = body.surfaces().stream()
                .filter(s ->
                        s.kind() == StructureKind.SKIN || s.kind() == StructureKind.LIVER || path.isMeasuredFrom(s))
                .flatMap(s -> body.notInScanOf(s).stream())
                .distinct()
                .collect(Collectors.joining(", "));
        return unseen.isEmpty() ? advice : advice.withRemark("not in the scan, and so not of this person: " + unseen);
    }

    public static PathAdvice of(PathOverBreath path) {
        int moments = path.analyses().size();
        int free = path.freeMoments();
        Map<String, Set<RespiratoryPhase>> phases = new LinkedHashMap<>();
        int tightest = -1;
        for (int m = 0; m < moments; m++) {
            RespiratoryPhase phase = path.cycle().get(m).label();
            for (String reason : path.reasons(m)) {
                phases.computeIfAbsent(reason, r -> new LinkedHashSet<>()).add(phase);
            }
            if (path.isFree(m)
                    && (tightest < 0
                            || path.margins().get(m).mm()
                                    < path.margins().get(tightest).mm())) {
                tightest = m;
            }
        }
        List<String> reasons = new ArrayList<>();
        phases.forEach((reason, of) -> reasons.add(free == 0 ? reason : reason + ": " + words(of)));
        boolean close = tightest >= 0 && path.margins().get(tightest).mm() < AccessMap.SUFFICIENT_MARGIN_MM;
        Level level = free == 0 ? Level.BARRED : free < moments || close ? Level.CAREFUL : Level.FREE;
        String headline = free == 0
                ? "Barred over the whole breath"
                : free < moments
                        ? "Free in " + Math.round(100.0 * free / moments) + " % of the breath"
                        : close ? "Free over the whole breath, but close" : "Free over the whole breath";
        String margin = tightest < 0
                ? ""
                : margin(path.margins().get(tightest).mm(), path.marginsFrom().get(tightest));
        return new PathAdvice(
                level,
                headline,
                List.copyOf(reasons),
                margin,
                way(path.analyses().get(0)));
    }

    /** Text such as "8.3 mm from right lung". */
    private static String margin(double marginMm, String nearest) {
        if (marginMm >= PathAnalyzer.MAX_DISTANCE_MM) {
            return "no structure at risk within " + Math.round(PathAnalyzer.MAX_DISTANCE_MM) + " mm";
        }
        return Numbers.format("%.1f mm from %s", marginMm, nearest);
    }

    /** A margin in mm, such as "8.3", or "40.0 or more". */
    static String margin(double marginMm) {
        return Numbers.format(marginMm >= PathAnalyzer.MAX_DISTANCE_MM ? "%.1f or more" : "%.1f", marginMm);
    }

    private static String way(PathAnalysis path) {
        double angle = path.capsuleAngleDeg();
        return Numbers.format("%.0f mm to the target", path.lengthMm())
                + ", " + path.way().label()
                + (Double.isNaN(angle) ? "" : Numbers.format(", %.0f\u00b0 to the liver's surface", angle));
    }

    private static String words(Set<RespiratoryPhase> phases) {
        return phases.stream()
                .map(phase -> switch (phase) {
                    case INSPIRATION -> "while breathing in";
                    case EXPIRATION -> "while breathing out";
                    case PAUSE -> "at the end of expiration";
                    case HOLD -> "in the held breath";
                })
                .collect(Collectors.joining(", "));
    }
}
