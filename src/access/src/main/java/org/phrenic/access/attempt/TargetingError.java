package org.phrenic.access.attempt;

import java.util.LinkedHashMap;
import java.util.Map;
import org.phrenic.access.TargetLesion;
import org.phrenic.mesh.Vectors;

/**
 * How a needle's tip lies to the middle of its target.
 *
 * @param axialMm how much deeper the middle lies, along the needle; negative where the tip is past it
 * @param lateralMm distance of the middle from the needle's line
 * @param hit whether the tip is within the target
 */
public record TargetingError(double axialMm, double lateralMm, boolean hit) {
    static TargetingError of(double[] tip, double[] direction, double[] middle, TargetLesion target) {
        double[] d = Vectors.subtract(middle, tip);
        double axial = Vectors.dot(d, direction);
        return new TargetingError(
                axial, Vectors.length(Vectors.addScaled(d, direction, -axial)), Vectors.length(d) <= target.radiusMm());
    }

    /** Distance between tip and middle, mm. */
    public double distanceMm() {
        return Math.sqrt(axialMm * axialMm + lateralMm * lateralMm);
    }

    /** Plain values for a report. */
    public Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("hit", hit);
        map.put("distance_mm", distanceMm());
        map.put("axial_mm", axialMm);
        map.put("lateral_mm", lateralMm);
        return map;
    }
}
