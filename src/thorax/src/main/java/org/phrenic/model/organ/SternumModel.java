package org.phrenic.model.organ;

import java.util.Locale;

/** What moves sternum and costal cartilages. */
public enum SternumModel {
    /** Springs, held to the ends of the ribs. */
    SPRINGS,
    /** A rigid fit to the ends of the ribs. */
    KINEMATIC,
    /** Nothing: they stand still. */
    OFF;

    /** Name in scenario files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
