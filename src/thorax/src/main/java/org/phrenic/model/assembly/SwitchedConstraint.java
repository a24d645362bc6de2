package org.phrenic.model.assembly;

import org.phrenic.engine.Constraint;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.parameter.RampedValue;

/** A constraint that can be switched on and off during a run. */
public final class SwitchedConstraint {
    private final RampedValue on;
    private final Constraint constraint;
    private final Runnable beforeOn;
    private boolean wasOn;
    private long disabledAtStep = -1;

    /** @param beforeOn runs when the constraint is switched on, unless it was switched off at the same step */
    public SwitchedConstraint(RampedValue on, Constraint constraint, Runnable beforeOn) {
        this.on = on;
        this.constraint = constraint;
        this.beforeOn = beforeOn;
    }

    private boolean isOn() {
        return on.target() == 1;
    }

    /** Called before the value of the switch may change. */
    public void beforeChange() {
        wasOn = isOn();
    }

    /** Called after the value of the switch may have changed. */
    public void afterChange(ParticleSystem system, long step) {
        if (isOn() && !wasOn && disabledAtStep != step) {
            beforeOn.run();
        }
        if (wasOn && !isOn()) {
            disabledAtStep = step;
        }
        system.setEnabled(constraint, isOn());
    }

    /** Applies the state of the switch at the start of a run. */
    public void restart(ParticleSystem system) {
        disabledAtStep = -1;
        system.setEnabled(constraint, isOn());
    }
}
