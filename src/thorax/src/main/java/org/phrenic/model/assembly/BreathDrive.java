package org.phrenic.model.assembly;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.BreathState;
import org.phrenic.engine.ForceField;

/**
 * Carries the breathing pattern into the scene: before forces are evaluated it tells the parts what the breath asks
 * for. It pulls on nothing itself.
 */
public final class BreathDrive implements ForceField {
    /** Sets what a part does at a time. */
    @FunctionalInterface
    public interface Action {
        void set(double timeS, BreathState breath);
    }

    /** A number that depends on time and breath. */
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

    /** @param pattern what is breathed */
    public BreathDrive(LiveBreathing pattern) {
        this.pattern = pattern;
    }

    /** Begins anew with other breathing. */
    public void restart(LiveBreathing anew) {
        pattern = anew;
        stateTime = Double.NaN;
    }

    /** Has something set before every evaluation of the forces. */
    public void beforeForces(Action action) {
        actions.add(action);
    }

    /** Says what the pressure on the abdominal face is. */
    public void measurePressure(Quantity transdiaphragmatic) {
        pressure = transdiaphragmatic;
    }

    /** Keeps everything at end-expiration, whatever the time, while a scene settles; or lets it breathe. */
    public void holdAtExpiration(boolean still) {
        heldAtExpiration = still;
        stateTime = Double.NaN;
    }

    /** What breathing asks for at a time. */
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

    /** Told that the pattern, or what multiplies it, is another from now on. */
    @Override
    public void invalidate() {
        stateTime = Double.NaN;
    }

    /** Pressure on the abdominal face at a time, kPa; 0 where none acts. */
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
