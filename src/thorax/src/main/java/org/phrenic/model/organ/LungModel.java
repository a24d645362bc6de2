package org.phrenic.model.organ;

import java.util.Locale;

/** Motion model of the lung surface. */
public enum LungModel {
    /** Springs, attached to diaphragm and chest wall. */
    SPRINGS,
    /** Each vertex follows the diaphragm and chest wall near it. */
    EMBEDDED,
    /** No lungs. */
    OFF;

    /** Name in scenario files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
