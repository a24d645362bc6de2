package org.phrenic.access.path;

import java.util.Map;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.OrderedValues;

/**
 * A stretch of a path within a structure.
 *
 * @param name of the structure, or {@link #RECESS}
 * @param label display name
 * @param kind OTHER for the recess
 * @param fromMm depth of the entry along the path
 * @param toMm depth of the exit, or the end of the path
 */
public record Crossing(String name, String label, StructureKind kind, double fromMm, double toMm) {
    /** Name of the pleural recess, which has no surface. */
    public static final String RECESS = "pleural_recess";

    /** Length within, mm. */
    public double lengthMm() {
        return toMm - fromMm;
    }

    /** Values for a report. */
    public Map<String, Object> toMap() {
        return new OrderedValues()
                .with("structure", name)
                .with("from_mm", fromMm)
                .with("to_mm", toMm);
    }
}
