package org.phrenic.access.attempt;

import java.util.Map;
import java.util.OptionalDouble;
import org.phrenic.access.TargetLesion;
import org.phrenic.document.OrderedValues;
import org.phrenic.mesh.Vectors;

/**
 * Position of a sample relative to the centre of the target. The sample of a core needle is a core that begins at the
 * tip, and is measured from its middle; that of another needle is at the tip.
 *
 * @param axialMm distance from the sample to the centre along the needle, mm; negative if the sample is past the centre
 * @param lateralMm distance of the centre from the axis of the needle, mm
 * @param hit whether the tip is in the liver and inside the target, or a part of the core inside the target
 * @param coreMm length of the core, which bone may end, mm; 0 without a core
 * @param coreInTargetMm length of the core inside the target, mm; empty without a core
 */
public record TargetingError(
        double axialMm, double lateralMm, boolean hit, double coreMm, OptionalDouble coreInTargetMm) {
    /**
     * Of a needle in its pose, to the place of the target's centre.
     *
     * @param core length of the core that a core needle cuts from there, mm; empty for another needle
     */
    static TargetingError of(NeedleShaft needle, double[] centre, TargetLesion target, OptionalDouble core) {
        double[] direction = needle.direction();
        double[] d = Vectors.subtract(centre, needle.tip());
        double axial = Vectors.dot(d, direction);
        double lateral = Vectors.length(Vectors.addScaled(d, direction, -axial));
        if (core.isEmpty()) {
            boolean hit = needle.isTipAnchored() && Vectors.length(d) <= target.radiusMm();
            return new TargetingError(axial, lateral, hit, 0, OptionalDouble.empty());
        }
        double coreMm = core.getAsDouble();
        double inTarget = chord(axial, lateral, target.radiusMm(), coreMm);
        return new TargetingError(axial - coreMm / 2, lateral, inTarget > 0, coreMm, OptionalDouble.of(inTarget));
    }

    /** Length of the part from 0 to {@code coreMm} of a line that lies in a ball. */
    private static double chord(double axial, double lateral, double radius, double coreMm) {
        double squared = radius * radius - lateral * lateral;
        if (squared <= 0) {
            return 0;
        }
        double half = Math.sqrt(squared);
        return Math.max(0, Math.min(coreMm, axial + half) - Math.max(0, axial - half));
    }

    /** Distance between sample and target centre, mm. */
    public double distanceMm() {
        return Math.sqrt(axialMm * axialMm + lateralMm * lateralMm);
    }

    public Map<String, Object> toMap() {
        OrderedValues map = new OrderedValues()
                .with("hit", hit)
                .with("distance_mm", distanceMm())
                .with("axial_mm", axialMm)
                .with("lateral_mm", lateralMm);
        coreInTargetMm.ifPresent(mm -> map.with("core_mm", coreMm).put("core_in_target_mm", mm));
        return map;
    }
}
