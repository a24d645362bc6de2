package org.phrenic.simulation;

import org.phrenic.breathing.Ramp;

/** A value that stands still or goes smoothly to another; a function of the time and of the turns made, not of the steps between. */
final class Dial {
    private Ramp ramp;
    private double target;
    private Ramp rampBefore;
    private double targetBefore;
    private long turned = -1;

    Dial(double value) {
        target = value;
    }

    /** Goes to another value from now on; of two turns at one step the first is as if it had not been. */
    void turn(double to, long step, double nowS) {
        if (step == turned) {
            ramp = rampBefore;
            target = targetBefore;
        }
        rampBefore = ramp;
        targetBefore = target;
        turned = step;
        if (Double.compare(to, target) != 0) {
            ramp = Ramp.of(at(nowS), to, nowS);
            target = to;
        }
    }

    /** Is at a value from now on, without a ramp. */
    void jump(double to) {
        ramp = null;
        target = to;
    }

    double at(double timeS) {
        return isDone(timeS) ? target : ramp.at(timeS);
    }

    /** Derivative, 1/s. */
    double rate(double timeS) {
        return isDone(timeS) ? 0 : ramp.rate(timeS);
    }

    double target() {
        return target;
    }

    /** Whether it has arrived. */
    boolean isDone(double timeS) {
        return ramp == null || ramp.done(timeS);
    }
}
