package org.phrenic.study.body;

import java.util.Locale;

/** The two breaths of a check, named as their presets. */
public enum BreathDepth {
    QUIET,
    DEEP;

    /** Name of the preset. */
    public String preset() {
        return name().toLowerCase(Locale.ROOT);
    }
}
