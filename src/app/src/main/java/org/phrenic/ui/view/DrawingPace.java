package org.phrenic.ui.view;

import org.phrenic.simulation.live.LiveRun;

/**
 * How often and how finely the view is drawn where the processor draws, so that simulated time keeps its pace: while
 * the simulation is behind, or a frame takes most of the time between two, fewer pixels are drawn, and at the coarsest
 * resolution fewer frames. When there is time again the resolution rises, one step after {@value #FIRST_WAIT_S} s; a
 * step that has to be taken back doubles this time. Time is given by the caller.
 */
final class DrawingPace {
    /** Drawn over shown pixels along each side. */
    private static final double[] RESOLUTIONS = {1, 0.85, 0.7, 0.6, 0.5};

    /** Shortest time between frames on a graphics card: 60 per second. */
    static final double CARD_FRAME_MS = 1000.0 / 60;

    /** Time between frames that the processor draws: a little more than 20 per second. */
    static final double FRAME_MS = 42;

    /** Longest time between frames while the simulation is behind. */
    static final double MAX_FRAME_MS = 80;

    /** Cost of a frame above which fewer pixels are drawn. */
    private static final double HIGH_COST_MS = 32;

    /** Expected cost of a frame below which more pixels are drawn. */
    private static final double LOW_COST_MS = 24;

    /** Time between frames over the cost of one, so that drawing leaves time for other work. */
    private static final double REST = 3;

    /** Cost that counts of a single frame at most; a longer one tells of other programs. */
    private static final double MAX_COST_MS = 60;

    private static final double SLOW_DOWN_MS = 4;
    private static final double SPEED_UP_MS = 0.5;
    private static final double PRESSED_S = 0.6;
    static final double FIRST_WAIT_S = 4;
    static final double MAX_WAIT_S = 128;

    /**
     * System property: least time between frames, ms. A process that looks at few of them leaves its processor to other
     * work; a picture that is asked for is drawn at once all the same.
     */
    private static final String LEAST_PROPERTY = "phrenic.frame_ms";

    /** Time after a step up in which a step down takes it back. */
    private static final double TAKEN_BACK_S = 6;

    private final double leastMs;
    private int step;
    private double costMs;
    private double extraMs;
    private double pressedSinceS = Double.NaN;
    private double easySinceS = Double.NaN;
    private double steppedUpS = Double.NEGATIVE_INFINITY;
    private double waitS = FIRST_WAIT_S;
    private boolean software;

    /** @param leastMs least time between frames, ms */
    DrawingPace(double leastMs) {
        this.leastMs = leastMs;
    }

    /** With the least time between frames that is set for this process; none without. */
    static DrawingPace ofProcess() {
        return new DrawingPace(Integer.getInteger(LEAST_PROPERTY, 0));
    }

    /** What drawing has to give way to. */
    enum Demand {
        /** The simulation keeps its pace, or is paused. */
        NONE,
        /** The simulation is behind its pace. */
        BEHIND,
        /** The simulation runs as fast as it can; frames become rarer, not coarser. */
        FLAT_OUT;

        static Demand of(LiveRun live) {
            if (!live.isPlaying()) {
                return NONE;
            }
            return live.isFlatOut() ? FLAT_OUT : live.isBehindRealTime() ? BEHIND : NONE;
        }
    }

    /**
     * Takes note of a frame.
     *
     * @param tookMs wall time of drawing it, ms
     * @param onProcessor whether the processor draws
     * @param nowS time, s
     */
    void drawn(double tookMs, Demand demand, boolean onProcessor, double nowS) {
        software = onProcessor;
        double counted = Math.min(tookMs, MAX_COST_MS);
        costMs = costMs == 0 ? counted : costMs + (counted - costMs) / 5;
        if (!software) {
            step = 0;
            return;
        }
        boolean pressed = demand == Demand.BEHIND || costMs > HIGH_COST_MS;
        double finer = step == 0 ? 1 : RESOLUTIONS[step - 1] / RESOLUTIONS[step];
        boolean easy = demand == Demand.NONE && costMs * finer * finer < LOW_COST_MS;
        pressedSinceS = since(pressedSinceS, pressed, nowS);
        easySinceS = since(easySinceS, easy, nowS);
        boolean rarer = demand == Demand.FLAT_OUT || (demand == Demand.BEHIND && step == RESOLUTIONS.length - 1);
        extraMs = Math.max(0, Math.min(MAX_FRAME_MS - FRAME_MS, extraMs + (rarer ? SLOW_DOWN_MS : -SPEED_UP_MS)));
        if (nowS - pressedSinceS >= PRESSED_S && step < RESOLUTIONS.length - 1) {
            waitS = nowS - steppedUpS < TAKEN_BACK_S ? Math.min(MAX_WAIT_S, 2 * waitS) : waitS;
            change(step + 1);
        } else if (nowS - easySinceS >= waitS && step > 0) {
            waitS = nowS - steppedUpS > 2 * waitS ? FIRST_WAIT_S : waitS;
            steppedUpS = nowS;
            change(step - 1);
        }
    }

    private static double since(double before, boolean holds, double nowS) {
        return !holds ? Double.NaN : Double.isNaN(before) ? nowS : before;
    }

    private void change(int to) {
        double ratio = RESOLUTIONS[to] / RESOLUTIONS[step];
        costMs *= ratio * ratio;
        step = to;
        pressedSinceS = Double.NaN;
        easySinceS = Double.NaN;
    }

    /** Drawn over shown pixels along each side, 0.5 to 1. */
    double resolution() {
        return RESOLUTIONS[step];
    }

    /** Time between the starts of two frames, ns. */
    long intervalNs() {
        double ms = software ? Math.max(CARD_FRAME_MS, Math.min(FRAME_MS, REST * costMs)) + extraMs : CARD_FRAME_MS;
        return (long) (1e6 * Math.max(leastMs, ms));
    }
}
