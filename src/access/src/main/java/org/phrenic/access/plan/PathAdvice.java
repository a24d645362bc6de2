package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.access.CostalGroove;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * Whether a path may be taken over a breath, in a clinician's words.
 *
 * @param level how it is marked
 * @param headline in a few words
 * @param reasons what is wrong with it and when, each a line; empty if nothing
 * @param margin how far it stays from what is to be avoided while it is free; empty where it never is
 * @param way its length, space and angle
 */
public record PathAdvice(Level level, String headline, List<String> reasons, String margin, String way) {
    /** How a path is marked: green, amber, red. */
    public enum Level {
        FREE,
        CAREFUL,
        BARRED
    }

    /** Of a path over a breath. */
    public static PathAdvice of(PathOverBreath path) {
        int moments = path.analyses().size();
        int free = path.freeMoments();
        Map<String, Set<RespiratoryPhase>> when = new LinkedHashMap<>();
        int tightest = -1;
        for (int m = 0; m < moments; m++) {
            RespiratoryPhase label = path.cycle().get(m).label();
            path.analyses().get(m).reasons(path.avoided()).forEach(reason -> when.computeIfAbsent(
                            reason, r -> new LinkedHashSet<>())
                    .add(label));
            if (path.isFree(m) && (tightest < 0 || path.marginsMm()[m] < path.marginsMm()[tightest])) {
                tightest = m;
            }
        }
        List<String> reasons = new ArrayList<>();
        when.forEach((reason, labels) -> reasons.add(free == 0 ? reason : reason + " " + words(labels)));
        boolean close = tightest >= 0 && path.marginsMm()[tightest] < Rehearsal.SUFFICIENT_MARGIN_MM;
        Level level = free == 0 ? Level.BARRED : free < moments || close ? Level.CAREFUL : Level.FREE;
        String headline = free == 0
                ? "Barred over the whole breath"
                : free < moments
                        ? "Free in " + Math.round(100.0 * free / moments) + " % of the breath"
                        : close ? "Free over the whole breath, but close" : "Free over the whole breath";
        return new PathAdvice(
                level,
                headline,
                List.copyOf(reasons),
                tightest < 0
                        ? ""
                        : margin(path.marginsMm()[tightest], path.analyses().get(tightest)),
                way(path.analyses().get(0)));
    }

    /** "8.3 mm from right lung". */
    private static String margin(double marginMm, PathAnalysis reading) {
        if (marginMm >= PathAnalyzer.MAX_DISTANCE_MM) {
            return "nothing to be avoided within " + Math.round(PathAnalyzer.MAX_DISTANCE_MM) + " mm";
        }
        boolean border = reading.approaches().isEmpty()
                || reading.costalGrooveMm() - CostalGroove.NEUROVASCULAR_ZONE_MM
                        < reading.approaches().get(0).distanceMm() - 1;
        String nearest = border
                ? "the vessels below " + reading.costalGrooveRib()
                : reading.approaches().get(0).label();
        return String.format(Locale.ROOT, "%.1f mm from %s", marginMm, nearest);
    }

    private static String way(PathAnalysis reading) {
        return String.format(Locale.ROOT, "%.0f mm to the target", reading.lengthMm())
                + reading.space().map(s -> ", " + s.label()).orElse("")
                + (Double.isNaN(reading.capsuleAngleDeg())
                        ? ""
                        : String.format(Locale.ROOT, ", %.0f\u00b0 to the liver's surface", reading.capsuleAngleDeg()));
    }

    private static String words(Set<RespiratoryPhase> labels) {
        return labels.stream()
                .map(label -> switch (label) {
                    case INSPIRATION -> "while breathing in";
                    case EXPIRATION -> "while breathing out";
                    case PAUSE -> "at the end of expiration";
                    case HOLD -> "in the held breath";
                })
                .collect(Collectors.joining(", "));
    }
}
