package org.phrenic.cli;

/** What every report ends with. */
final class Notice {
    static final String TEXT = org.phrenic.format.Notice.TEXT;

    private Notice() {}
}
