package org.phrenic.model.organ;

import java.util.Locale;

/** What moves the surface of the lungs. */
public enum LungModel {
    /** Springs, held to diaphragm and chest wall. */
    SPRINGS,
    /** Each vertex follows the diaphragm and chest wall near it. */
    EMBEDDED,
    /** Nothing: there are no lungs. */
    OFF;

    /** Name in scenario files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
