package org.phrenic.model.organ;

/** Motion model of sternum and costal cartilages. */
public enum SternumModel {
    /** Springs, attached to the ends of the ribs. */
    SPRINGS,
    /** A rigid fit to the ends of the ribs. */
    KINEMATIC,
    /** No motion. */
    OFF
}
