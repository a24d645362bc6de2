package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.access.NoGoZone;

/**
 * What a straight path from the skin meets, at one moment.
 *
 * @param timeS of the frame
 * @param lengthMm of the path
 * @param crossings structures in the order in which they are entered; one that is entered twice stands twice
 * @param space the intercostal space it passes, if it passes one
 * @param approaches nearest first: each lung, bone and other organ within reach of {@link PathAnalyzer#MAX_DISTANCE_MM}
 * @param costalGrooveMm distance from the nearest lower border of a rib, no more than
 *     {@link PathAnalyzer#MAX_DISTANCE_MM}
 * @param costalGrooveRib the rib of that border; empty where none is near
 * @param capsuleAngleDeg between the path and the liver's surface where it enters, 90 straight in; NaN if it does not
 * @param noGo what it touches of {@link NoGoZone}
 */
public record PathAnalysis(
        double timeS,
        double lengthMm,
        List<Crossing> crossings,
        Optional<IntercostalSpace> space,
        List<Approach> approaches,
        double costalGrooveMm,
        String costalGrooveRib,
        double capsuleAngleDeg,
        Set<NoGoZone> noGo) {
    /** The first stretch within a structure. */
    public Optional<Crossing> crossing(String name) {
        return crossings.stream().filter(c -> c.name().equals(name)).findFirst();
    }

    /**
     * Why a path should not be taken, in words such as "crosses right rib 8"; empty if nothing of {@code avoided} is
     * touched.
     *
     * @param avoided what counts
     */
    public List<String> reasons(Set<NoGoZone> avoided) {
        List<String> reasons = new ArrayList<>();
        if (noGo.contains(NoGoZone.LUNG) && avoided.contains(NoGoZone.LUNG)) {
            reasons.add("crosses lung");
        }
        for (Approach a : approaches) {
            boolean bone = a.label().contains("rib") || a.label().contains("cartilage");
            if (a.distanceMm() == 0 && bone && avoided.contains(NoGoZone.BONE)) {
                reasons.add("crosses " + a.label());
            }
        }
        if (reasons.isEmpty() && noGo.contains(NoGoZone.BONE) && avoided.contains(NoGoZone.BONE)) {
            reasons.add("touches bone");
        }
        if (noGo.contains(NoGoZone.VESSELS) && avoided.contains(NoGoZone.VESSELS)) {
            reasons.add("runs close below " + costalGrooveRib + ", where its vessels and nerve are");
        }
        if (noGo.contains(NoGoZone.PLEURA) && avoided.contains(NoGoZone.PLEURA)) {
            reasons.add("crosses the pleural recess");
        }
        if (noGo.contains(NoGoZone.ORGAN) && avoided.contains(NoGoZone.ORGAN)) {
            reasons.add("crosses another organ");
        }
        return reasons;
    }

    /** Plain values for a report. */
    public Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("time_s", timeS);
        map.put("length_mm", lengthMm);
        map.put("space", space.map(IntercostalSpace::label).orElse("none"));
        map.put("crossings", crossings.stream().map(Crossing::toMap).toList());
        map.put("closest", approaches.stream().limit(8).map(Approach::toMap).toList());
        if (!costalGrooveRib.isEmpty()) {
            map.put("rib_lower_border_mm", costalGrooveMm);
            map.put("rib_lower_border_of", costalGrooveRib);
        }
        if (!Double.isNaN(capsuleAngleDeg)) {
            map.put("capsule_angle_deg", capsuleAngleDeg);
        }
        map.put("no_go", noGo.stream().map(NoGoZone::key).collect(Collectors.toList()));
        return map;
    }
}
