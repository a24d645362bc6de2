package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.document.OrderedValues;

/**
 * The structures that a straight path from the skin crosses or approaches at one moment.
 *
 * @param timeS simulated time of the frame, s
 * @param crossings crossed structures in order of entry; a structure entered twice is listed twice
 * @param way the way by which the path enters the trunk
 * @param approaches lungs, bones and other organs within {@link PathAnalyzer#MAX_DISTANCE_MM}, nearest first
 * @param costalGrooveMm distance to the nearest costal groove, mm, at most {@link PathAnalyzer#MAX_DISTANCE_MM}
 * @param costalGrooveRib rib of that groove; empty if none is in range
 * @param capsuleAngleDeg angle between path and liver surface at the entry, degrees; 90 is perpendicular, NaN if the
 *     path does not enter the liver
 * @param noGo no-go zones that the path touches
 */
public record PathAnalysis(
        double timeS,
        double lengthMm,
        List<Crossing> crossings,
        EntryWay way,
        List<Approach> approaches,
        double costalGrooveMm,
        String costalGrooveRib,
        double capsuleAngleDeg,
        Set<NoGoZone> noGo) {
    /** The intercostal space that the path passes through, if any. */
    public Optional<IntercostalSpace> space() {
        return way.space();
    }

    /** Whether the path crosses the pleura, in its recess or through a lung. */
    public boolean crossesPleura() {
        return noGo.contains(NoGoZone.PLEURA);
    }

    /** The first crossing of a structure. */
    public Optional<Crossing> crossing(String name) {
        return crossings.stream().filter(c -> c.name().equals(name)).findFirst();
    }

    /**
     * Reasons why the path is not free for a needle, such as "crosses right rib 8". Empty if it touches no zone of
     * {@code avoided} and is no longer than the needle.
     */
    public List<String> reasons(Set<NoGoZone> avoided, Needle needle) {
        List<String> reasons = new ArrayList<>();
        if (needle.isShorterThan(lengthMm)) {
            reasons.add("is longer than the needle of " + needle.length());
        }
        reasons.addAll(touches(avoided));
        return reasons;
    }

    /** What of {@code avoided} the path touches, such as "crosses right rib 8". Empty if it touches no such zone. */
    public List<String> touches(Set<NoGoZone> avoided) {
        List<String> reasons = new ArrayList<>();
        addIfTouched(reasons, NoGoZone.LUNG, avoided, "crosses lung");
        int beforeBone = reasons.size();
        if (avoided.contains(NoGoZone.BONE)) {
            approaches.stream()
                    .filter(a -> a.distanceMm() == 0)
                    .map(Approach::label)
                    .filter(label -> label.contains("rib") || label.contains("cartilage"))
                    .forEach(label -> reasons.add("crosses " + label));
        }
        if (reasons.size() == beforeBone) {
            addIfTouched(reasons, NoGoZone.BONE, avoided, "touches bone");
        }
        String vessels = "runs close below " + costalGrooveRib + ", where its vessels and nerve are";
        addIfTouched(reasons, NoGoZone.VESSELS, avoided, vessels);
        addIfTouched(reasons, NoGoZone.PLEURA, avoided, "crosses the pleura, " + way.label());
        if (avoided.contains(NoGoZone.ORGAN) && noGo.contains(NoGoZone.ORGAN)) {
            String crossed = crossings.stream()
                    .filter(c -> NoGoZone.of(c.kind()).equals(Optional.of(NoGoZone.ORGAN)))
                    .filter(c -> !c.name().equals(Crossing.RECESS))
                    .map(Crossing::label)
                    .distinct()
                    .collect(Collectors.joining(", "));
            reasons.add(crossed.isEmpty() ? "touches " + nearestOrgan() : "crosses " + crossed);
        }
        return reasons;
    }

    /** The nearest organ or vessel, by name. */
    private String nearestOrgan() {
        return approaches.stream()
                .filter(a -> NoGoZone.of(a.kind()).equals(Optional.of(NoGoZone.ORGAN)))
                .map(Approach::label)
                .findFirst()
                .orElseGet(NoGoZone.ORGAN::label);
    }

    private void addIfTouched(List<String> reasons, NoGoZone zone, Set<NoGoZone> avoided, String reason) {
        if (noGo.contains(zone) && avoided.contains(zone)) {
            reasons.add(reason);
        }
    }

    public Map<String, Object> toMap() {
        OrderedValues map = new OrderedValues()
                .with("time_s", timeS)
                .with("length_mm", lengthMm)
                .with("space", space().map(IntercostalSpace::label).orElse("none"))
                .with("way", way.label())
                .with("crosses_pleura", crossesPleura())
                .with("crossings", crossings.stream().map(Crossing::toMap).toList())
                .with(
                        "closest",
                        approaches.stream().limit(8).map(Approach::toMap).toList());
        if (!costalGrooveRib.isEmpty()) {
            map.with("rib_lower_border_mm", costalGrooveMm).with("rib_lower_border_of", costalGrooveRib);
        }
        if (!Double.isNaN(capsuleAngleDeg)) {
            map.put("capsule_angle_deg", capsuleAngleDeg);
        }
        return map.with("no_go", noGo.stream().map(NoGoZone::key).toList());
    }
}
