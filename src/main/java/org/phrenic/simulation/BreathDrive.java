package org.phrenic.simulation;

import org.phrenic.anatomy.RibCagePose;
import org.phrenic.anatomy.RibGains;
import org.phrenic.breathing.BreathState;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.force.ActionLine;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.force.Springs;

/**
 * Carries the breathing pattern into the scene: at every time that forces are asked for it sets the activation of the muscle, the pressure on the abdominal face, the force of the action lines and the turn of
 * the ribs. It pulls on nothing itself.
 */
final class BreathDrive implements ForceField, RibCagePose.Drive {
    private LiveBreath pattern;
    private final BreathState state = new BreathState();
    private Dial ribRotation;
    private Dial activationScale;
    private Dial restPressure;
    private Dial pressureScale;
    private Dial pressureSides;
    private Dial upperRibs;
    private Dial lowerRibs;
    private Dial ribSides;
    private Dial bucket;
    private Dial[] mediastinum;
    private Dial lungStiffness;
    private Dial coupling;
    private Dial lineForce;
    private Springs muscle;
    private FacePressure pressure;
    private ActionLine[] lines = {};
    private ConstantLoad[] outward = {};
    private boolean atRest;
    private double stateTime = Double.NaN;

    /**
     * @param pattern what is breathed
     * @param dials how much each drive does
     */
    BreathDrive(LiveBreath pattern, Dials dials) {
        restart(pattern, dials);
    }

    /** Begins anew with other breathing; parameters as for the constructor. */
    final void restart(LiveBreath anew, Dials dials) {
        pattern = anew;
        stateTime = Double.NaN;
        ribRotation = dials.of(Knob.RIB_ROTATION);
        activationScale = dials.of(Knob.ACTIVATION);
        restPressure = dials.of(Knob.REST_PRESSURE);
        pressureScale = dials.of(Knob.EFFORT_PRESSURE);
        pressureSides = dials.of(Knob.PRESSURE_SIDES);
        upperRibs = dials.of(Knob.UPPER_RIBS);
        lowerRibs = dials.of(Knob.LOWER_RIBS);
        ribSides = dials.of(Knob.RIB_SIDES);
        bucket = dials.of(Knob.BUCKET);
        mediastinum = new Dial[] {dials.of(Knob.MEDIASTINUM_RIGHT), dials.of(Knob.MEDIASTINUM_LEFT)};
        lungStiffness = dials.of(Knob.LUNG_STIFFNESS);
        coupling = dials.of(Knob.COUPLING);
        lineForce = dials.of(Knob.LINE_FORCE);
    }

    void drives(Springs springs) {
        muscle = springs;
    }

    void drives(FacePressure faces) {
        pressure = faces;
    }

    /** @param loads what pushes the mediastinal surface of the right and of the left lung out by 1 mm, over the stiffness of lungs and coupling */
    void drives(ConstantLoad... loads) {
        outward = loads;
    }

    void drives(ActionLine[] actionLines) {
        lines = actionLines;
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

    LiveBreath pattern() {
        return pattern;
    }

    /** Told that the pattern, or what multiplies it, is another from now on. */
    @Override
    public void forget() {
        stateTime = Double.NaN;
    }

    /** Pressure on the abdominal face at a time, kPa; 0 where none acts. */
    double pressureAt(double time) {
        BreathState s = stateAt(time);
        return pressure == null
                ? 0
                : restPressure.at(time) + pressureScale.at(time) * (s.pressure + s.abdominalPressure);
    }

    @Override
    public void at(double time, double[] amplitudeAndRate) {
        BreathState s = stateAt(time);
        double rotation = ribRotation.at(time);
        amplitudeAndRate[0] = rotation * s.ribTurn;
        amplitudeAndRate[1] = rotation * s.ribTurnRate + ribRotation.rate(time) * s.ribTurn;
    }

    @Override
    public boolean gains(double time, RibGains gains) {
        double upper = upperRibs.at(time);
        double lower = lowerRibs.at(time);
        double sides = ribSides.at(time);
        double side = bucket.at(time);
        if (upper == 1 && lower == 1 && sides == 1 && side == 1) {
            return false;
        }
        gains.setBucket(side);
        gains.set(upper, lower, sides);
        gains.setRates(upperRibs.rate(time), lowerRibs.rate(time), ribSides.rate(time));
        return true;
    }

    @Override
    public void prepare(double time) {
        BreathState s = stateAt(time);
        if (muscle != null) {
            muscle.setActivation(activationScale.at(time) * s.activation);
        }
        if (pressure != null) {
            double leftOverRight = pressureSides.at(time);
            double effort = pressureScale.at(time) * (s.pressure + s.abdominalPressure);
            double right = Math.min(1, 1 / leftOverRight);
            pressure.setPressure(restPressure.at(time) + right * effort);
            pressure.setMore((Math.min(1, leftOverRight) - right) * effort);
        }
        double inspired = 0.5 * (s.activation + s.ribTurn) * lungStiffness.at(time) * coupling.at(time);
        for (int i = 0; i < outward.length; i++) {
            outward[i].setFactor(inspired * mediastinum[i].at(time));
        }
        for (ActionLine line : lines) {
            line.setForce(lineForce.at(time) * s.activation);
        }
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {}
}
