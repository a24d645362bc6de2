package org.phrenic.parameter;

import java.util.function.ToDoubleFunction;
import org.phrenic.breathing.Ramp;

/**
 * The value of a parameter or switch in a run: it stands still or goes smoothly to another over {@link Ramp#DEFAULT_S}.
 * A function of the time and of the changes made, not of the steps between.
 */
public final class RampedValue {
    private final ToDoubleFunction<SettingValues> valueIn;
    private Ramp ramp;
    private double target;
    private Ramp previousRamp;
    private double previousTarget;
    private long changedAtStep = -1;

    /**
     * @param valueIn its value in a scenario
     * @param values of the scenario at the start
     */
    RampedValue(ToDoubleFunction<SettingValues> valueIn, SettingValues values) {
        this.valueIn = valueIn;
        target = valueIn.applyAsDouble(values);
    }

    /** Its value in a scenario. */
    public double in(SettingValues values) {
        return valueIn.applyAsDouble(values);
    }

    /** Goes to its value in a scenario from now on; of two changes at one step the first is as if it had not been. */
    public void rampTo(SettingValues values, long step, double nowS) {
        rampTo(in(values), step, nowS);
    }

    /** Goes to another value from now on. */
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

    /** Stands at its value in a scenario, as at the start of a run. */
    void restart(SettingValues values) {
        ramp = null;
        target = in(values);
        changedAtStep = -1;
    }

    /** Value at a time, s. */
    public double at(double timeS) {
        return hasArrived(timeS) ? target : ramp.at(timeS);
    }

    /** Derivative, 1/s. */
    public double rate(double timeS) {
        return hasArrived(timeS) ? 0 : ramp.rate(timeS);
    }

    /** Where it stands or goes to. */
    public double target() {
        return target;
    }

    /** Whether it has arrived. */
    public boolean hasArrived(double timeS) {
        return ramp == null || ramp.isDone(timeS);
    }
}
