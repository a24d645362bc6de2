package org.phrenic.model.organ;

import java.util.Locale;

/** Which part of the sheet is central tendon. */
public enum TendonRule {
    /** The three-leaved region of anatomy. */
    TREFOIL,
    /** All that lies above a horizontal plane, as in the paper. */
    PLANE;

    /** Name in scenario files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
