package org.phrenic.model.assembly;

import java.util.Arrays;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.SettingValues;

/** Updates springs, attachments or masses when one of some parameters changes. Allocates nothing after construction. */
public final class TissueTuner {
    /** Update to perform when a value has changed. */
    @FunctionalInterface
    public interface Action {
        /**
         * Updates for new parameter values.
         *
         * @param value current value of each parameter
         * @param assembled value of each parameter at assembly
         * @param asAssembled whether all values equal those at assembly
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

    /** Applies the values of given settings. */
    public void apply(SettingValues settings) {
        for (int i = 0; i < value.length; i++) {
            value[i] = parameters[i].in(settings);
        }
        apply();
    }

    /** Restores the values at assembly. */
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
