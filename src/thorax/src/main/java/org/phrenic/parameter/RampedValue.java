package org.phrenic.parameter;

import java.util.function.ToDoubleFunction;
import org.phrenic.breathing.Ramp;

/**
 * Value of a parameter or switch during a run: constant, or changing smoothly to a target over {@link Ramp#DEFAULT_S}.
 * It is a function of the time and of the changes made, not of the steps in between.
 */
public final class RampedValue {
    private final ToDoubleFunction<SettingValues> valueIn;
    private Ramp ramp;
    private double target;
    private Ramp previousRamp;
    private double previousTarget;
    private long changedAtStep = -1;

    /**
     * @param valueIn extracts the value from settings
     * @param values of the scenario at the start
     */
    RampedValue(ToDoubleFunction<SettingValues> valueIn, SettingValues values) {
        this.valueIn = valueIn;
        target = valueIn.applyAsDouble(values);
    }

    /** Its value in given settings. */
    public double in(SettingValues values) {
        return valueIn.applyAsDouble(values);
    }

    /** Starts a ramp to its value in given settings. Of two changes at one step only the second applies. */
    public void rampTo(SettingValues values, long step, double nowS) {
        rampTo(in(values), step, nowS);
    }

    /** Starts a ramp to another value. */
    void rampTo(double to, long step, double nowS) {
        if (step == changedAtStep) {
            ramp = previousRamp;
            target = previousTarget;
        }
        previousRamp = ramp;
        previousTarget = target;
        changedAtStep = step;
        if (Double.compare(to, target) != 0) {
            ramp = Ramp.of(at(nowS), to, nowS);
            target = to;
        }
    }

    /** Sets the value to that in given settings without a ramp, as at the start of a run. */
    void restart(SettingValues values) {
        ramp = null;
        target = in(values);
        changedAtStep = -1;
    }

    /** Value at a time, s. */
    public double at(double timeS) {
        return hasArrived(timeS) ? target : ramp.at(timeS);
    }

    /** Time derivative, 1/s. */
    public double rate(double timeS) {
        return hasArrived(timeS) ? 0 : ramp.rate(timeS);
    }

    /** Target of the ramp, or the constant value. */
    public double target() {
        return target;
    }

    /** Target before the changes of a step. */
    double targetBefore(long step) {
        return step == changedAtStep ? previousTarget : target;
    }

    /** Whether the ramp before the changes of a step had ended at a time. */
    boolean hadArrived(long step, double timeS) {
        return isDone(step == changedAtStep ? previousRamp : ramp, timeS);
    }

    /** Whether the ramp has ended. */
    public boolean hasArrived(double timeS) {
        return isDone(ramp, timeS);
    }

    private static boolean isDone(Ramp ramp, double timeS) {
        return ramp == null || ramp.isDone(timeS);
    }
}
