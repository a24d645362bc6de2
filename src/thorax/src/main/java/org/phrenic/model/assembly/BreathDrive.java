package org.phrenic.model.assembly;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.BreathState;
import org.phrenic.engine.ForceField;

/**
 * Applies the breathing pattern to a scene: before every force evaluation it updates the parts that the breath drives.
 * It exerts no force itself.
 */
public final class BreathDrive implements ForceField {
    /** Updates a part for a time and a breath state. */
    @FunctionalInterface
    public interface Action {
        void set(double timeS, BreathState breath);
    }

    /** A quantity that depends on time and breath state. */
    @FunctionalInterface
    public interface Quantity {
        double at(double timeS, BreathState breath);
    }

    private final List<Action> actions = new ArrayList<>();
    private final BreathState state = new BreathState();
    private LiveBreathing pattern;
    private Quantity pressure = (time, breath) -> 0;
    private boolean heldAtExpiration;
    private double stateTime = Double.NaN;

    /** @param pattern breathing pattern */
    public BreathDrive(LiveBreathing pattern) {
        this.pattern = pattern;
    }

    /** Restarts with another breathing pattern. */
    public void restart(LiveBreathing anew) {
        pattern = anew;
        stateTime = Double.NaN;
    }

    /** Adds an action that runs before every force evaluation. */
    public void beforeForces(Action action) {
        actions.add(action);
    }

    /** Sets the quantity that gives the pressure on the abdominal face. */
    public void measurePressure(Quantity transdiaphragmatic) {
        pressure = transdiaphragmatic;
    }

    /** Holds the breath at end-expiration at all times while a scene settles, or releases it. */
    public void holdAtExpiration(boolean still) {
        heldAtExpiration = still;
        stateTime = Double.NaN;
    }

    /** Breath state at a time. */
    public BreathState breathAt(double time) {
        if (time != stateTime) {
            stateTime = time;
            pattern.at(heldAtExpiration ? 0 : time, state);
        }
        return state;
    }

    public LiveBreathing pattern() {
        return pattern;
    }

    /** Called when the pattern or one of its factors has changed. */
    @Override
    public void invalidate() {
        stateTime = Double.NaN;
    }

    /** Pressure on the abdominal face at a time, kPa; 0 without pressure. */
    public double pressureAt(double time) {
        return pressure.at(time, breathAt(time));
    }

    @Override
    public void prepare(double time) {
        BreathState breath = breathAt(time);
        for (int i = 0; i < actions.size(); i++) {
            actions.get(i).set(time, breath);
        }
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {}
}
