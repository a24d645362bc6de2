package org.phrenic.access.attempt;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.Approach;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.document.report.Disclaimer;

/**
 * What is kept of an attempt. The measures are those that tell levels of experience apart in biopsy simulators (Johnson
 * et al. 2012, BJR 85:555) and those that a moving target adds; none of their thresholds is validated.
 *
 * @param samples how the tip lay at each sample
 * @param events in the order in which they were noted
 * @param timeS from the first contact with the skin to the last sample or withdrawal
 * @param insideS with the tip below the skin
 * @param tipTravelMm that the tip was moved by hand, forth and back
 * @param inNoGoS with any part of the needle in what is to be avoided
 * @param secondsIn by kind
 * @param closest closest approach of the needle to each structure, by name
 * @param borderMm closest approach to the lower border of a rib, at most {@link PathAnalyzer#MAX_DISTANCE_MM}
 * @param targetExcursionMm greatest distance of the target from where it was when the skin was punctured, up to the
 *     first sample
 * @param targetRangeMm range of the target meanwhile in x, y, z
 * @param capsulePullMm how far at most the capsule's puncture was pulled aside of the needle
 * @param rotationByLiverDeg how far at most the liver turned the needle
 * @param driftByLiverMm by how much the liver moved the tip along the needle, up and down added up
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
        Map<NoGoZone, Double> secondsIn,
        List<Approach> closest,
        double borderMm,
        double targetExcursionMm,
        double[] targetRangeMm,
        double capsulePullMm,
        double rotationByLiverDeg,
        double driftByLiverMm) {
    /** Pull on the capsule from which on a warning is given, mm: chosen, not validated. */
    public static final double PULL_WARNING_MM = 5;

    /** Said wherever a record is shown. */
    public static final String NOT_VALIDATED =
            "Thresholds (hit, no-go zones, pull on the capsule) are choices of this program and not validated.";

    /** Whether a sample was taken within the target. */
    public boolean hit() {
        return samples.stream().anyMatch(TargetingError::hit);
    }

    /** How many events of a kind there are. */
    public int count(AttemptEvent.Kind kind) {
        return (int) events.stream().filter(e -> e.kind() == kind).count();
    }

    /** The first event of a kind. */
    public Optional<AttemptEvent> first(AttemptEvent.Kind kind) {
        return events.stream().filter(e -> e.kind() == kind).findFirst();
    }

    /** The measures that matter most, by keys that hold their unit. */
    public Map<String, Object> headlines() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("hit", hit());
        if (!samples.isEmpty()) {
            TargetingError last = samples.get(samples.size() - 1);
            map.put("axial_error_mm", last.axialMm());
            map.put("lateral_error_mm", last.lateralMm());
        }
        map.put("attempts", count(AttemptEvent.Kind.SKIN_PUNCTURE));
        map.put("redirections", count(AttemptEvent.Kind.REDIRECTION));
        map.put("skin_contacts", count(AttemptEvent.Kind.SKIN_CONTACT));
        map.put("bone_contacts", count(AttemptEvent.Kind.BONE_CONTACT));
        map.put("time_s", timeS);
        map.put("inside_s", insideS);
        map.put("path_mm", tipTravelMm);
        map.put("in_no_go_s", inNoGoS);
        map.put("target_moved_mm", targetExcursionMm);
        map.put("capsule_pull_mm", capsulePullMm);
        return map;
    }

    /** Plain values for a report. */
    public Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>(headlines());
        map.put("samples", samples.stream().map(TargetingError::toMap).toList());
        Map<String, Object> seconds = new LinkedHashMap<>();
        for (NoGoZone one : NoGoZone.values()) {
            seconds.put(one.key(), secondsIn.getOrDefault(one, 0.0));
        }
        map.put("seconds_in", seconds);
        map.put("avoided", avoided.stream().sorted().map(NoGoZone::key).toList());
        map.put("target_diameter_mm", target.diameterMm());
        map.put("target_rest_mm", target.restMm());
        map.put("target_range_lr_ap_si_mm", targetRangeMm);
        map.put("capsule_pull_warning", capsulePullMm > PULL_WARNING_MM);
        map.put("needle_turned_by_liver_deg", rotationByLiverDeg);
        map.put("needle_moved_along_by_liver_mm", driftByLiverMm);
        map.put("rib_lower_border_mm", borderMm);
        map.put(
                "closest",
                closest.stream()
                        .sorted(Comparator.comparingDouble(Approach::distanceMm).thenComparing(Approach::name))
                        .map(Approach::toMap)
                        .toList());
        map.put("events", events.stream().map(AttemptEvent::toMap).toList());
        map.put("needle_gauge", needle.gauge());
        map.put("needle_length_mm", needle.lengthMm());
        map.put("thresholds", NOT_VALIDATED);
        map.put("notice", Disclaimer.TEXT);
        return map;
    }
}
