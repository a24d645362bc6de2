package org.phrenic.ui.widget;

/** What the program is not for. */
public final class WindowNotice {
    public static final String TEXT = org.phrenic.document.report.Disclaimer.TEXT;

    private WindowNotice() {}
}
