package org.phrenic.access.path;

import java.util.Map;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.OrderedValues;

/**
 * A segment of a path that lies inside a structure.
 *
 * @param name name of the structure, or {@link #RECESS}
 * @param label display name
 * @param kind kind of the structure; OTHER for the recess
 * @param fromMm depth of the entry along the path, mm
 * @param toMm depth of the exit, or of the end of the path, mm
 */
public record Crossing(String name, String label, StructureKind kind, double fromMm, double toMm) {
    /** Name used for the pleural recess, which has no surface of its own. */
    public static final String RECESS = "pleural_recess";

    /** Length of the segment, mm. */
    public double lengthMm() {
        return toMm - fromMm;
    }

    public Map<String, Object> toMap() {
        return new OrderedValues()
                .with("structure", name)
                .with("from_mm", fromMm)
                .with("to_mm", toMm);
    }
}
