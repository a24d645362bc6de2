package org.phrenic.access.attempt;

import java.util.Map;
import org.phrenic.access.TargetLesion;
import org.phrenic.document.OrderedValues;
import org.phrenic.mesh.Vectors;

/**
 * Position of the needle tip relative to the centre of the target.
 *
 * @param axialMm distance from the tip to the centre along the needle, mm; negative if the tip is past the centre
 * @param lateralMm distance of the centre from the axis of the needle, mm
 * @param hit whether the tip is inside the target
 */
public record TargetingError(double axialMm, double lateralMm, boolean hit) {
    static TargetingError of(double[] tip, double[] direction, double[] centre, TargetLesion target) {
        double[] d = Vectors.subtract(centre, tip);
        double axial = Vectors.dot(d, direction);
        double lateral = Vectors.length(Vectors.addScaled(d, direction, -axial));
        return new TargetingError(axial, lateral, Vectors.length(d) <= target.radiusMm());
    }

    /** Distance between tip and target centre, mm. */
    public double distanceMm() {
        return Math.sqrt(axialMm * axialMm + lateralMm * lateralMm);
    }

    public Map<String, Object> toMap() {
        return new OrderedValues()
                .with("hit", hit)
                .with("distance_mm", distanceMm())
                .with("axial_mm", axialMm)
                .with("lateral_mm", lateralMm);
    }
}
