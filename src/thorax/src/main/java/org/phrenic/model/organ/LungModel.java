package org.phrenic.model.organ;

/** Motion model of the lung surface. */
public enum LungModel {
    /** Springs, attached to diaphragm and chest wall. */
    SPRINGS,
    /** Each vertex follows the diaphragm and chest wall near it. */
    EMBEDDED,
    /** No lungs. */
    OFF
}
