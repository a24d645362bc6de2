package org.phrenic.simulation;

import org.phrenic.anatomy.RibCagePose;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.force.ActionLine;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.force.Springs;

/**
 * Carries the breathing pattern into the scene: at every time that forces are asked for it sets the activation of the muscle, the pressure on the abdominal face, the force of the action lines and the turn of
 * the ribs. It pulls on nothing itself.
 */
final class BreathDrive implements ForceField, RibCagePose.Drive {
    private final BreathingPattern pattern;
    private final BreathState state = new BreathState();
    private final double ribRotation;
    private double activationScale;
    private double restPressure;
    private double pressureScale;
    private double lineForce;
    private Springs muscle;
    private FacePressure pressure;
    private ActionLine[] lines = {};
    private boolean atRest;
    private double stateTime = Double.NaN;

    /**
     * @param ribRotation multiplies the turn of the ribs; 0 keeps them still
     */
    BreathDrive(BreathingPattern pattern, double ribRotation) {
        this.pattern = pattern;
        this.ribRotation = ribRotation;
    }

    void drives(Springs springs, double activationAtFullDrive) {
        muscle = springs;
        activationScale = activationAtFullDrive;
    }

    void drives(FacePressure faces, double atRest_kpa, double greatest_kpa) {
        pressure = faces;
        restPressure = atRest_kpa;
        pressureScale = greatest_kpa;
    }

    void drives(ActionLine[] actionLines, double forceAtFullDrive) {
        lines = actionLines;
        lineForce = forceAtFullDrive;
    }

    /** Keeps everything at end-expiration, whatever the time, while a scene settles; or lets it breathe. */
    void hold(boolean still) {
        atRest = still;
        stateTime = Double.NaN;
    }

    /** What breathing asks for at a time. */
    BreathState stateAt(double time) {
        if (time != stateTime) {
            stateTime = time;
            pattern.at(atRest ? 0 : time, state);
        }
        return state;
    }

    BreathingPattern pattern() {
        return pattern;
    }

    /** Pressure on the abdominal face at a state, kPa. */
    double pressureAt(BreathState s) {
        return restPressure + pressureScale * (s.pressure + s.abdominalPressure);
    }

    @Override
    public void at(double time, double[] amplitudeAndRate) {
        BreathState s = stateAt(time);
        amplitudeAndRate[0] = ribRotation * s.ribTurn;
        amplitudeAndRate[1] = ribRotation * s.ribTurnRate;
    }

    @Override
    public void prepare(double time) {
        BreathState s = stateAt(time);
        if (muscle != null) {
            muscle.setActivation(activationScale * s.activation);
        }
        if (pressure != null) {
            pressure.setPressure(pressureAt(s));
        }
        for (ActionLine line : lines) {
            line.setForce(lineForce * s.activation);
        }
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {}
}
