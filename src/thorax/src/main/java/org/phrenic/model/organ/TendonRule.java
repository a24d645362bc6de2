package org.phrenic.model.organ;

import java.util.Locale;

/** Rule that selects the central tendon of the sheet. */
public enum TendonRule {
    /** The anatomical trefoil (three leaflets). */
    TREFOIL,
    /** Everything above a horizontal plane, as in the paper. */
    PLANE;

    /** Name in scenario files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
