package org.phrenic.model.organ;

/** Rule that selects the central tendon of the sheet. */
public enum TendonRule {
    /** The anatomical trefoil (three leaflets). */
    TREFOIL,
    /** Everything above a horizontal plane, as in the paper. */
    PLANE
}
