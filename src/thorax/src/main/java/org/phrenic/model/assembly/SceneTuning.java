package org.phrenic.model.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.parameter.RampedValues;
import org.phrenic.parameter.SettingValues;

/** What of a scene can be changed while it runs, as the parts said it. */
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

    /** Has something set step by step while a setting of {@link org.phrenic.parameter.Effect#SCENE} is on its way. */
    public void whileRamping(DoubleConsumer action) {
        whileRamping.add(action);
    }

    void switches(SwitchedConstraint constraint) {
        switched.add(constraint);
    }

    /** Told when the scene has settled: its shape is now that at rest, which tuning leaves as it is. */
    public void settled() {
        pending.forEach(tuner -> tissue.add(tuner.get()));
        pending.clear();
    }

    /** The values of all parameters. */
    public RampedValues values() {
        return values;
    }

    /** Gives tissue the numbers of a time, s. */
    public void applyTissue(double timeS) {
        for (TissueTuner tuner : tissue) {
            tuner.applyAt(timeS);
        }
    }

    /** Gives tissue the numbers of some settings. */
    public void applyTissue(SettingValues settings) {
        tissue.forEach(tuner -> tuner.apply(settings));
    }

    /** Sets what else ramps to where it is at a time, s. */
    public void applyRamps(double timeS) {
        for (DoubleConsumer action : whileRamping) {
            action.accept(timeS);
        }
    }

    /** All parameters and switches go to their values in some settings. */
    public void rampTo(SettingValues settings, ParticleSystem system, long step, double nowS) {
        switched.forEach(SwitchedConstraint::beforeChange);
        values.rampTo(settings, step, nowS);
        switched.forEach(constraint -> constraint.afterChange(system, step));
    }

    /** All stand at their values in some settings, with the tissue as assembled. */
    public void restart(SettingValues settings, ParticleSystem system) {
        values.restart(settings);
        tissue.forEach(TissueTuner::restoreAssembled);
        applyRamps(0);
        switched.forEach(constraint -> constraint.restart(system));
    }
}
