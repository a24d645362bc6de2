package org.phrenic.ui.access;

import org.phrenic.access.plan.Aids;

/** How pictures are shown in a rehearsal. May be read on any thread. */
public final class GuidanceSettings {
    /** Usual time from the moment of an ultrasound image to its display, s. */
    public static final double DEFAULT_LATENCY_S = 0.1;

    private volatile double latencyS = DEFAULT_LATENCY_S;
    private volatile Aids aids = Aids.SEE_THROUGH;

    public double latencyS() {
        return latencyS;
    }

    public void setLatencyS(double seconds) {
        latencyS = seconds;
    }

    /** What is shown of the body. */
    public Aids aids() {
        return aids;
    }

    void setAids(Aids shown) {
        aids = shown;
    }

    boolean isSeeThrough() {
        return aids == Aids.SEE_THROUGH;
    }
}
