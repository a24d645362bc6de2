package org.phrenic.ui;

/** What the program is not for. */
final class Notice {
    static final String TEXT = org.phrenic.format.Notice.TEXT;

    private Notice() {}
}
