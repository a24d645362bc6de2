package org.phrenic.access.attempt;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.Approach;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;

/**
 * Measures of an attempt. They include the measures that distinguish levels of experience in biopsy simulators (Johnson
 * et al. 2012, BJR 85:555) and additional measures for a moving target. The thresholds are not validated.
 *
 * @param samples targeting error of each sample
 * @param timeS time from first skin contact to the last sample or withdrawal, s
 * @param insideS time with the tip below the skin, s
 * @param tipTravelMm total distance that the user moved the tip, forward and backward, mm
 * @param inNoGoS time with any part of the needle in an avoided zone, s
 * @param zones time in each zone, and what the throw of a core touched
 * @param closest closest approach of the needle to each structure, by name
 * @param borderMm closest approach to a costal groove, at most
 *     {@link org.phrenic.access.path.PathAnalyzer#MAX_DISTANCE_MM}
 * @param targetExcursionMm largest distance of the target from its position at skin puncture, up to the first sample,
 *     mm
 * @param targetRangeMm range of the target along x, y and z during the same time, mm
 * @param capsulePullMm largest distance of the needle from its puncture point in the liver capsule, mm
 * @param driftByLiverMm total movement of the tip along the needle caused by liver motion, mm
 * @param loads greatest loads on the needle
 */
public record AttemptRecord(
        TargetLesion target,
        Needle needle,
        Set<NoGoZone> avoided,
        List<TargetingError> samples,
        List<AttemptEvent> events,
        double timeS,
        double insideS,
        double tipTravelMm,
        double inNoGoS,
        ZoneContacts zones,
        List<Approach> closest,
        double borderMm,
        double targetExcursionMm,
        double[] targetRangeMm,
        double capsulePullMm,
        double driftByLiverMm,
        NeedleLoads loads) {
    /** A warning is given if the capsule is pulled further than this, mm. The value is chosen, not validated. */
    public static final double PULL_WARNING_MM = 5;

    /** Disclaimer shown with every record. */
    public static final String NOT_VALIDATED =
            "Thresholds (hit, no-go zones, pull on the capsule) are choices of this program and not validated.";

    /** Whether a sample was taken inside the target. */
    public boolean hit() {
        return samples.stream().anyMatch(TargetingError::hit);
    }

    /**
     * The sample that tells what came of the attempt: of those that hit, the nearest to the middle of the target; if
     * none hit, the last.
     */
    public Optional<TargetingError> decisive() {
        return samples.stream()
                .filter(TargetingError::hit)
                .min(Comparator.comparingDouble(TargetingError::distanceMm))
                .or(this::last);
    }

    /** The last sample. */
    public Optional<TargetingError> last() {
        return samples.isEmpty() ? Optional.empty() : Optional.of(samples.get(samples.size() - 1));
    }

    /** Whether the target was hit, such as "Missed" or, of several samples, "Hit in 1 of 2 samples". */
    public String verdict() {
        int taken = samples.size();
        if (taken == 0) {
            return "No sample";
        }
        long hits = samples.stream().filter(TargetingError::hit).count();
        String counted = hits > 0 ? " in " + hits + " of " + taken + " samples" : " in " + taken + " samples";
        return (hits > 0 ? "Hit" : "Missed") + (taken > 1 ? counted : "");
    }

    /** Which of several samples {@link #decisive} is, such as "in the last, "; empty if there is no other. */
    public String whichSample() {
        return samples.size() < 2 ? "" : hit() ? "in the nearest that hit, " : "in the last, ";
    }

    /** Largest rotation of the needle caused by liver motion, degrees. */
    public double rotationByLiverDeg() {
        return loads.rotationDeg();
    }

    /** Time in each zone, s. */
    public Map<NoGoZone, Double> secondsIn() {
        return zones.secondsIn();
    }

    /** Whether the throw of a core touched an avoided zone that the needle itself did not. */
    public boolean isCoreInNoGo() {
        return zones.byCore().stream().anyMatch(avoided::contains);
    }

    public int count(AttemptEvent.Kind kind) {
        return (int) events.stream().filter(e -> e.kind() == kind).count();
    }

    public Optional<AttemptEvent> first(AttemptEvent.Kind kind) {
        return events.stream().filter(e -> e.kind() == kind).findFirst();
    }

    /** The main measures. Keys include the unit. */
    public OrderedValues headlines() {
        OrderedValues map = new OrderedValues().with("hit", hit());
        last().ifPresent(sample ->
                map.with("axial_error_mm", sample.axialMm()).with("lateral_error_mm", sample.lateralMm()));
        return map.with("attempts", count(AttemptEvent.Kind.SKIN_PUNCTURE))
                .with("redirections", count(AttemptEvent.Kind.REDIRECTION))
                .with("skin_contacts", count(AttemptEvent.Kind.SKIN_CONTACT))
                .with("bone_contacts", count(AttemptEvent.Kind.BONE_CONTACT))
                .with("time_s", timeS)
                .with("inside_s", insideS)
                .with("path_mm", tipTravelMm)
                .with("in_no_go_s", inNoGoS)
                .with("target_moved_mm", targetExcursionMm)
                .with("capsule_pull_mm", capsulePullMm);
    }

    public Map<String, Object> toMap() {
        OrderedValues seconds = new OrderedValues();
        for (NoGoZone zone : NoGoZone.values()) {
            seconds.put(zone.key(), secondsIn().getOrDefault(zone, 0.0));
        }
        OrderedValues map = headlines()
                .with("samples", samples.stream().map(TargetingError::toMap).toList())
                .with("seconds_in", seconds);
        if (needle.coreMm() > 0) {
            map.put("touched_by_core", keys(zones.byCore()));
        }
        return map.with("avoided", keys(avoided))
                .with("target_diameter_mm", target.diameterMm())
                .with("target_rest_mm", target.restMm())
                .with("target_range_lr_ap_si_mm", targetRangeMm)
                .with("capsule_pull_warning", capsulePullMm > PULL_WARNING_MM)
                .with("needle_turned_by_liver_deg", rotationByLiverDeg())
                .with("needle_moved_along_by_liver_mm", driftByLiverMm)
                .with("loads", loads.toMap())
                .with("rib_lower_border_mm", borderMm)
                .with(
                        "closest",
                        closest.stream()
                                .sorted(Approach.NEAREST_FIRST)
                                .map(Approach::toMap)
                                .toList())
                .with("events", events.stream().map(AttemptEvent::toMap).toList())
                .with("needle_gauge", needle.gauge())
                .with("needle_length_mm", needle.lengthMm())
                .with("thresholds", NOT_VALIDATED)
                .with("notice", Disclaimer.TEXT);
    }

    private static List<String> keys(Set<NoGoZone> zones) {
        return zones.stream().sorted().map(NoGoZone::key).toList();
    }
}
