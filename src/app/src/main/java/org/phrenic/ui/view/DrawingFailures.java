package org.phrenic.ui.view;

/**
 * The frames and tasks that have failed, with no successful one between: a number of different ones ends the view, as
 * with a lost context each of them fails. One picture that fails each time, for lack of memory for its size perhaps, is
 * tried again ever more slowly; another may succeed.
 */
final class DrawingFailures {
    private static final int MOST = 20;
    private static final long FIRST_REST_NS = 5_000_000;
    /** How much longer each failure lets wait. */
    private static final long LONGER_NS = 20_000_000;

    private static final long LONGEST_REST_NS = 1_000_000_000;

    private int different;
    private int all;
    private long last = -1;

    /** Something was drawn or done. */
    void end() {
        different = 0;
        all = 0;
        last = -1;
    }

    /**
     * Counts a failure.
     *
     * @param attempt number of what was tried; that of the last failure if it was tried again
     * @return whether this was tried for the first time
     */
    boolean add(long attempt) {
        boolean first = attempt != last;
        all++;
        different += first ? 1 : 0;
        last = attempt;
        return first;
    }

    /** Whether nothing can be drawn any more. */
    boolean areTooMany() {
        return different >= MOST;
    }

    /** Time until the next turn in which nothing is to be done, ns. */
    long restNs() {
        return Math.min(LONGEST_REST_NS, FIRST_REST_NS + all * LONGER_NS);
    }
}
