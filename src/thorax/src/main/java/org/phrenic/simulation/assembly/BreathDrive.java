package org.phrenic.simulation.assembly;

import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.RibGains;
import org.phrenic.breathing.BreathState;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.force.ActionLine;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.force.Springs;

/**
 * Carries the breathing pattern into the scene: at every time that forces are asked for it sets the activation of the
 * muscle, the pressure on the abdominal face, the force of the action lines and the turn of the ribs. It pulls on
 * nothing itself.
 */
public final class BreathDrive implements ForceField, RibCagePose.RibDrive {
    private LiveBreathing pattern;
    private final BreathState state = new BreathState();
    private RampedValue ribRotation;
    private RampedValue activationScale;
    private RampedValue restPressure;
    private RampedValue pressureScale;
    private RampedValue pressureSides;
    private RampedValue upperRibs;
    private RampedValue lowerRibs;
    private RampedValue ribSides;
    private RampedValue bucketHandle;
    private RampedValue[] mediastinum;
    private RampedValue lungStiffness;
    private RampedValue coupling;
    private RampedValue lineForce;
    private Springs muscle;
    private FacePressure pressure;
    private ActionLine[] lines = {};
    private ConstantLoad[] mediastinalLoads = {};
    private boolean heldAtExpiration;
    private double stateTime = Double.NaN;

    /**
     * @param pattern what is breathed
     * @param dials how much each drive does
     */
    public BreathDrive(LiveBreathing pattern, RampedValues dials) {
        restart(pattern, dials);
    }

    /** Begins anew with other breathing; parameters as for the constructor. */
    public final void restart(LiveBreathing anew, RampedValues dials) {
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
        bucketHandle = dials.of(Knob.BUCKET);
        mediastinum = new RampedValue[] {dials.of(Knob.MEDIASTINUM_RIGHT), dials.of(Knob.MEDIASTINUM_LEFT)};
        lungStiffness = dials.of(Knob.LUNG_STIFFNESS);
        coupling = dials.of(Knob.COUPLING);
        lineForce = dials.of(Knob.LINE_FORCE);
    }

    void attach(Springs springs) {
        muscle = springs;
    }

    void attach(FacePressure faces) {
        pressure = faces;
    }

    /**
     * @param loads what pushes the mediastinal surface of the right and of the left lung out by 1 mm, over the
     *     stiffness of lungs and coupling
     */
    void attach(ConstantLoad... loads) {
        mediastinalLoads = loads;
    }

    void attach(ActionLine[] actionLines) {
        lines = actionLines;
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
        BreathState s = breathAt(time);
        return pressure == null
                ? 0
                : restPressure.at(time) + pressureScale.at(time) * (s.pressure + s.abdominalPressure);
    }

    @Override
    public void at(double time, double[] amplitudeAndRate) {
        BreathState s = breathAt(time);
        double rotation = ribRotation.at(time);
        amplitudeAndRate[0] = rotation * s.ribTurn;
        amplitudeAndRate[1] = rotation * s.ribTurnRate + ribRotation.rate(time) * s.ribTurn;
    }

    @Override
    public boolean gains(double time, RibGains gains) {
        double upper = upperRibs.at(time);
        double lower = lowerRibs.at(time);
        double sides = ribSides.at(time);
        double side = bucketHandle.at(time);
        if (upper == 1 && lower == 1 && sides == 1 && side == 1) {
            return false;
        }
        gains.setBucket(side);
        gains.setFactors(upper, lower, sides);
        gains.setRates(upperRibs.rate(time), lowerRibs.rate(time), ribSides.rate(time));
        return true;
    }

    @Override
    public void prepare(double time) {
        BreathState s = breathAt(time);
        if (muscle != null) {
            muscle.setActivation(activationScale.at(time) * s.activation);
        }
        if (pressure != null) {
            double leftOverRight = pressureSides.at(time);
            double effort = pressureScale.at(time) * (s.pressure + s.abdominalPressure);
            double right = Math.min(1, 1 / leftOverRight);
            pressure.setPressure(restPressure.at(time) + right * effort);
            pressure.setSecondaryPressure((Math.min(1, leftOverRight) - right) * effort);
        }
        double inspired = 0.5 * (s.activation + s.ribTurn) * lungStiffness.at(time) * coupling.at(time);
        for (int i = 0; i < mediastinalLoads.length; i++) {
            mediastinalLoads[i].setLoadFactor(inspired * mediastinum[i].at(time));
        }
        for (ActionLine line : lines) {
            line.setForce(lineForce.at(time) * s.activation);
        }
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {}
}
