package org.phrenic.model.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.parameter.RampedValues;
import org.phrenic.parameter.SettingValues;

/** Parts of a scene that can change during a run, as registered during assembly. */
public final class SceneTuning {
    private final RampedValues values;
    private final List<Supplier<TissueTuner>> pending = new ArrayList<>();
    private final List<TissueTuner> tissue = new ArrayList<>();
    private final List<DoubleConsumer> whileRamping = new ArrayList<>();
    private final List<SwitchedConstraint> switched = new ArrayList<>();

    SceneTuning(RampedValues values) {
        this.values = values;
    }

    void whenSettled(Supplier<TissueTuner> tuner) {
        pending.add(tuner);
    }

    /**
     * Registers an action that runs at every step while a setting of {@link org.phrenic.parameter.Effect#SCENE} ramps.
     */
    public void whileRamping(DoubleConsumer action) {
        whileRamping.add(action);
    }

    void switches(SwitchedConstraint constraint) {
        switched.add(constraint);
    }

    /** Called when the scene has settled. Its shape is then the rest shape, which tuning preserves. */
    public void settled() {
        pending.forEach(tuner -> tissue.add(tuner.get()));
        pending.clear();
    }

    /** Values of all parameters. */
    public RampedValues values() {
        return values;
    }

    /** Applies the tissue parameters at a time, s. */
    public void applyTissue(double timeS) {
        for (TissueTuner tuner : tissue) {
            tuner.applyAt(timeS);
        }
    }

    /** Applies the tissue parameters of given settings. */
    public void applyTissue(SettingValues settings) {
        tissue.forEach(tuner -> tuner.apply(settings));
    }

    /** Applies all other ramping values at a time, s. */
    public void applyRamps(double timeS) {
        for (DoubleConsumer action : whileRamping) {
            action.accept(timeS);
        }
    }

    /** Ramps all parameters and switches to their values in given settings. */
    public void rampTo(SettingValues settings, ParticleSystem system, long step, double nowS) {
        switched.forEach(SwitchedConstraint::beforeChange);
        values.rampTo(settings, step, nowS);
        switched.forEach(constraint -> constraint.afterChange(system, step));
    }

    /** Resets all values to those of given settings, with the tissue as assembled. */
    public void restart(SettingValues settings, ParticleSystem system) {
        values.restart(settings);
        tissue.forEach(TissueTuner::restoreAssembled);
        applyRamps(0);
        switched.forEach(constraint -> constraint.restart(system));
    }
}
