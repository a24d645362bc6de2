package org.phrenic.cli;

/** Exit codes of the program. */
final class ExitCode {
    static final int SUCCESS = 0;
    static final int FAILURE = 1;
    static final int BAD_INPUT = 2;
    /** A regression test, a validation or a performance goal failed. */
    static final int CHECK_FAILED = 3;

    static final int NO_GRAPHICS = 4;

    private ExitCode() {}
}
