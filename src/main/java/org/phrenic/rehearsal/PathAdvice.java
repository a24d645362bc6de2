package org.phrenic.rehearsal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.breathing.BreathLabel;

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
    public static PathAdvice of(PathCycle path) {
        int moments = path.readings().size();
        int free = path.freeMoments();
        Map<String, Set<BreathLabel>> when = new LinkedHashMap<>();
        int tightest = -1;
        for (int m = 0; m < moments; m++) {
            BreathLabel label = path.cycle().get(m).label();
            path.readings().get(m).reasons(path.avoided()).forEach(reason -> when.computeIfAbsent(
                            reason, r -> new LinkedHashSet<>())
                    .add(label));
            if (path.isFree(m) && (tightest < 0 || path.marginsMm()[m] < path.marginsMm()[tightest])) {
                tightest = m;
            }
        }
        List<String> reasons = new ArrayList<>();
        when.forEach((reason, labels) -> reasons.add(free == 0 ? reason : reason + " " + words(labels)));
        boolean close = tightest >= 0 && path.marginsMm()[tightest] < Rehearsal.ROOM_MM;
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
                        : margin(path.marginsMm()[tightest], path.readings().get(tightest)),
                way(path.readings().get(0)));
    }

    /** "8.3 mm from right lung". */
    private static String margin(double marginMm, PathReading reading) {
        if (marginMm >= PathReader.REACH_MM) {
            return "nothing to be avoided within " + Math.round(PathReader.REACH_MM) + " mm";
        }
        boolean border = reading.approaches().isEmpty()
                || reading.borderMm() - RibBorder.ZONE_MM
                        < reading.approaches().get(0).distanceMm() - 1;
        String nearest = border
                ? "the vessels below " + reading.borderOf()
                : reading.approaches().get(0).label();
        return String.format(Locale.ROOT, "%.1f mm from %s", marginMm, nearest);
    }

    private static String way(PathReading reading) {
        return String.format(Locale.ROOT, "%.0f mm to the target", reading.lengthMm())
                + reading.space().map(s -> ", " + s.label()).orElse("")
                + (Double.isNaN(reading.capsuleAngleDeg())
                        ? ""
                        : String.format(Locale.ROOT, ", %.0f\u00b0 to the liver's surface", reading.capsuleAngleDeg()));
    }

    private static String words(Set<BreathLabel> labels) {
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
