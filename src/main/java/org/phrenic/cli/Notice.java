package org.phrenic.cli;

/** What every report ends with. */
final class Notice {
    static final String TEXT = "For research and training only. Not for clinical use.";

    private Notice() {}
}
