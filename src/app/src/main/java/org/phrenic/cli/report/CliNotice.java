package org.phrenic.cli.report;

/** What every report ends with. */
public final class CliNotice {
    public static final String TEXT = org.phrenic.document.report.Disclaimer.TEXT;

    private CliNotice() {}
}
