package org.phrenic.cli.report;

/** Exit codes of the program. */
public final class ExitCode {
    public static final int SUCCESS = 0;
    public static final int FAILURE = 1;
    public static final int BAD_INPUT = 2;
    /** A regression test, a validation or a performance goal failed. */
    public static final int CHECK_FAILED = 3;

    public static final int NO_GRAPHICS = 4;

    private ExitCode() {}
}
