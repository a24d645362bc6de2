package org.phrenic.format;

/** What the program is not for: said on the first screen and in every report. */
public final class Notice {
    public static final String TEXT = "For research and training only. Not for clinical use.";

    private Notice() {}
}
