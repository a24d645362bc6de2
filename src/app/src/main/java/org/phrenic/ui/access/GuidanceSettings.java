package org.phrenic.ui.access;

import org.phrenic.access.plan.Aids;

/** How pictures are shown in a rehearsal, and what is shown of the body. May be read on any thread. */
public final class GuidanceSettings {
    /** Usual time from the moment of an ultrasound image to its display, s. */
    public static final double DEFAULT_LATENCY_S = 0.1;

    /**
     * Angles of the C-arm, degrees.
     *
     * @param leftObliqueDeg toward the patient's left
     * @param cranialDeg toward the head
     */
    public record ArmAngles(double leftObliqueDeg, double cranialDeg) {}

    private volatile double latencyS = DEFAULT_LATENCY_S;
    private volatile boolean xrayOn;
    private volatile ArmAngles armAngles = new ArmAngles(0, 0);
    private volatile Aids aids = Aids.SEE_THROUGH;
    private Aids mostHelp = Aids.SEE_THROUGH;
    /** Whether an attempt has ended in this run and the needle of the next is not placed. */
    private boolean awaitsNeedle;

    public double latencyS() {
        return latencyS;
    }

    public void setLatencyS(double seconds) {
        latencyS = seconds;
    }

    public boolean isXrayOn() {
        return xrayOn;
    }

    public void setXrayOn(boolean on) {
        xrayOn = on;
    }

    public ArmAngles armAngles() {
        return armAngles;
    }

    public void setArmAngles(ArmAngles angles) {
        armAngles = angles;
    }

    /** What is shown of the body. */
    public Aids aids() {
        return aids;
    }

    void setAids(Aids shown) {
        aids = shown;
        if (shown.compareTo(mostHelp) < 0) {
            mostHelp = shown;
        }
    }

    /** Begins an attempt. */
    void begin() {
        mostHelp = aids;
        awaitsNeedle = false;
    }

    /** Ends an attempt; the next in the same run begins when its needle is placed. */
    void end() {
        begin();
        awaitsNeedle = true;
    }

    /** The needle is placed on the skin. */
    void place() {
        if (awaitsNeedle) {
            begin();
        }
    }

    /** The most help that has been shown in the attempt. */
    Aids mostHelp() {
        return mostHelp;
    }

    boolean isSeeThrough() {
        return aids == Aids.SEE_THROUGH;
    }
}
