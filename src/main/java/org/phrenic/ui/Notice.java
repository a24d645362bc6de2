package org.phrenic.ui;

/** What the program is not for. */
final class Notice {
    static final String TEXT = "For research and training only. Not for clinical use.";

    private Notice() {}
}
