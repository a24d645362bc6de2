package org.phrenic.model.assembly;

import org.phrenic.engine.Constraint;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.parameter.RampedValue;

/** A constraint that can be switched on and off while a scene runs. */
public final class SwitchedConstraint {
    private final RampedValue on;
    private final Constraint constraint;
    private final Runnable beforeOn;
    private boolean wasOn;
    private long disabledAtStep = -1;

    /** @param beforeOn done when it is switched on, unless it was switched off at the same step */
    public SwitchedConstraint(RampedValue on, Constraint constraint, Runnable beforeOn) {
        this.on = on;
        this.constraint = constraint;
        this.beforeOn = beforeOn;
    }

    private boolean isOn() {
        return on.target() == 1;
    }

    /** Told before the switch may go to another value. */
    public void beforeChange() {
        wasOn = isOn();
    }

    /** Told when the switch may have gone to another value. */
    public void afterChange(ParticleSystem system, long step) {
        if (isOn() && !wasOn && disabledAtStep != step) {
            beforeOn.run();
        }
        if (wasOn && !isOn()) {
            disabledAtStep = step;
        }
        system.setEnabled(constraint, isOn());
    }

    /** Takes the state of the switch, as at the start of a run. */
    public void restart(ParticleSystem system) {
        disabledAtStep = -1;
        system.setEnabled(constraint, isOn());
    }
}
