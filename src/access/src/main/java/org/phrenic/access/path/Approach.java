package org.phrenic.access.path;

import java.util.Collection;
import java.util.Comparator;
import java.util.Map;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.OrderedValues;

/**
 * Closest approach of a path to a structure.
 *
 * @param name name of the structure
 * @param label display name
 * @param kind kind of the structure
 * @param distanceMm distance between path and surface, mm; 0 if the path crosses the surface
 * @param depthMm depth of the nearest point along the path, mm
 */
public record Approach(String name, String label, StructureKind kind, double distanceMm, double depthMm) {
    /** The order by distance; equal distances by name. */
    public static final Comparator<Approach> NEAREST_FIRST =
            Comparator.comparingDouble(Approach::distanceMm).thenComparing(Approach::name);

    /** Merges approaches into a map that keeps the smallest distance for each structure. */
    public static void merge(Map<String, Approach> closest, Collection<Approach> approaches) {
        approaches.forEach(a -> closest.merge(a.name, a, (x, y) -> y.distanceMm < x.distanceMm ? y : x));
    }

    public Map<String, Object> toMap() {
        return new OrderedValues()
                .with("structure", name)
                .with("distance_mm", distanceMm)
                .with("depth_mm", depthMm);
    }
}
