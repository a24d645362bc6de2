package org.phrenic.access.path;

import java.util.Collection;
import java.util.Map;
import org.phrenic.document.OrderedValues;

/**
 * The closest approach of a path to a structure.
 *
 * @param name of the structure
 * @param label display name
 * @param distanceMm between path and surface; 0 where the path crosses it
 * @param depthMm depth along the path of the nearest point
 */
public record Approach(String name, String label, double distanceMm, double depthMm) {
    /** Keeps the closest approach to each structure, by name. */
    public static void merge(Map<String, Approach> closest, Collection<Approach> approaches) {
        approaches.forEach(a -> closest.merge(a.name, a, (x, y) -> y.distanceMm < x.distanceMm ? y : x));
    }

    /** Values for a report. */
    public Map<String, Object> toMap() {
        return new OrderedValues()
                .with("structure", name)
                .with("distance_mm", distanceMm)
                .with("depth_mm", depthMm);
    }
}
