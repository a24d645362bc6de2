package org.phrenic.simulation.assembly;

import org.phrenic.breathing.Ramp;

/**
 * A value that stands still or goes smoothly to another; a function of the time and of the turns made, not of the steps
 * between.
 */
final class RampedValue {
    private Ramp ramp;
    private double target;
    private Ramp previousRamp;
    private double previousTarget;
    private long rampedAtStep = -1;

    RampedValue(double value) {
        target = value;
    }

    /** Goes to another value from now on; of two turns at one step the first is as if it had not been. */
    void rampTo(double to, long step, double nowS) {
        if (step == rampedAtStep) {
            ramp = previousRamp;
            target = previousTarget;
        }
        previousRamp = ramp;
        previousTarget = target;
        rampedAtStep = step;
        if (Double.compare(to, target) != 0) {
            ramp = Ramp.of(at(nowS), to, nowS);
            target = to;
        }
    }

    /** Is at a value from now on, without a ramp. */
    void set(double to) {
        ramp = null;
        target = to;
    }

    double at(double timeS) {
        return hasArrived(timeS) ? target : ramp.at(timeS);
    }

    /** Derivative, 1/s. */
    double rate(double timeS) {
        return hasArrived(timeS) ? 0 : ramp.rate(timeS);
    }

    double target() {
        return target;
    }

    /** Whether it has arrived. */
    boolean hasArrived(double timeS) {
        return ramp == null || ramp.isDone(timeS);
    }
}
