package org.phrenic.access.path;

import java.util.LinkedHashMap;
import java.util.Map;
import org.phrenic.anatomy.StructureKind;

/**
 * A stretch of a path within a structure.
 *
 * @param name of the structure, or {@link #RECESS}
 * @param label name for people
 * @param kind what it is; OTHER for the recess
 * @param fromMm depth at which the path enters, from the skin along the path
 * @param toMm depth at which it leaves, or the path's end
 */
public record Crossing(String name, String label, StructureKind kind, double fromMm, double toMm) {
    /** Name of the pleural recess, which no surface shows. */
    public static final String RECESS = "pleural_recess";

    /** Length within, mm. */
    public double lengthMm() {
        return toMm - fromMm;
    }

    /** Plain values for a report. */
    public Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("structure", name);
        map.put("from_mm", fromMm);
        map.put("to_mm", toMm);
        return map;
    }
}
