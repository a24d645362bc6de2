package org.phrenic.access.path;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * How near a path comes to a structure.
 *
 * @param name of the structure
 * @param label name for people
 * @param distanceMm between the path and its surface; 0 where it is crossed
 * @param depthMm depth along the path at which it is nearest
 */
public record Approach(String name, String label, double distanceMm, double depthMm) {
    /** Plain values for a report. */
    public Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("structure", name);
        map.put("distance_mm", distanceMm);
        map.put("depth_mm", depthMm);
        return map;
    }
}
