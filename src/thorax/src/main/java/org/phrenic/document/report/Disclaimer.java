package org.phrenic.document.report;

/** The limits of intended use, shown on the first screen and in every report. */
public final class Disclaimer {
    public static final String TEXT = "For research and training only. Not for clinical use.";

    private Disclaimer() {}
}
