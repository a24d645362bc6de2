package org.phrenic.cli;

/** What a command leaves for whoever started it. */
final class ExitCode {
    static final int SUCCESS = 0;
    static final int FAILURE = 1;
    static final int BAD_INPUT = 2;
    /** What was measured misses a range in which there is confidence. */
    static final int CHECK_FAILED = 3;

    static final int NO_GRAPHICS = 4;

    private ExitCode() {}
}
