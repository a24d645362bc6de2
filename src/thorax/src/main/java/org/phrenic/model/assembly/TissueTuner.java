package org.phrenic.model.assembly;

import java.util.Arrays;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.SettingValues;

/**
 * Gives springs, attachments or masses the numbers that go with the values of some parameters, whenever one of these is
 * another. Allocates nothing after construction.
 */
public final class TissueTuner {
    /** What is done when a value has changed. */
    @FunctionalInterface
    public interface Action {
        /**
         * @param value of each parameter
         * @param assembled value of each when the scene was assembled
         * @param asAssembled whether all are as assembled
         */
        void tune(double[] value, double[] assembled, boolean asAssembled);
    }

    private final RampedValue[] parameters;
    private final Action action;
    private final double[] assembled;
    private final double[] applied;
    private final double[] value;

    public TissueTuner(RampedValue[] parameters, Action action) {
        this.parameters = parameters;
        this.action = action;
        assembled = Arrays.stream(parameters).mapToDouble(RampedValue::target).toArray();
        applied = assembled.clone();
        value = assembled.clone();
    }

    /** Applies the values at a time, s. */
    public void applyAt(double timeS) {
        for (int i = 0; i < value.length; i++) {
            value[i] = parameters[i].at(timeS);
        }
        apply();
    }

    /** Applies the values of some settings. */
    public void apply(SettingValues settings) {
        for (int i = 0; i < value.length; i++) {
            value[i] = parameters[i].in(settings);
        }
        apply();
    }

    /** Applies the values as assembled. */
    public void restoreAssembled() {
        System.arraycopy(assembled, 0, value, 0, value.length);
        apply();
    }

    private void apply() {
        if (!Arrays.equals(value, applied)) {
            action.tune(value, assembled, Arrays.equals(value, assembled));
            System.arraycopy(value, 0, applied, 0, value.length);
        }
    }
}
