package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathWaveform;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * Some breaths, then one that is held, then breaths again.
 *
 * <p>Held at inspiration, the diaphragm creeps back although the breath is held: its drive decays as {@code exp(-lambda
 * g)}, {@code g} the time held (with a smooth first second), so that it has lost the creep fraction after
 * {@value #CREEP_TIME_S} s. Measured in 15 people: up to 5.6 mm towards the head in 24 s, 123 ml less in the lung
 * (PMC7055431). The ribs stay. Held at expiration everything rests, and there is nothing that could creep.
 */
public final class HoldPattern extends NamedPattern {
    /** Hold over which the creep is stated, s. */
    public static final double CREEP_TIME_S = 24;

    /** Creep gathers speed over this time, s, so that the hold begins without a jerk. */
    private static final double CREEP_ONSET_S = 1;

    private final PeriodicPattern around;
    private final double startS;
    private final int breathsBefore;
    private final double holdS;
    private final boolean atInspiration;
    private final double creepRate;
    private final double heldPeriodS;
    private final double inspirationS;
    private final double resumeS;
    private final BreathWaveform wave;
    private final RespiratoryDrive drive;

    /**
     * A held breath among others.
     *
     * @param name what to call it
     * @param around the breaths before and after
     * @param breathsBefore how many before
     * @param held the breath that is held: its depth, and its rate and fractions for the way in and out; null to hold
     *     at end-expiration
     * @param holdS how long, s, above 0
     * @param creepFraction share of the drive lost in {@value #CREEP_TIME_S} s, from 0 to below 1
     */
    public HoldPattern(
            String name,
            BreathingParameters around,
            int breathsBefore,
            BreathingParameters held,
            double holdS,
            double creepFraction) {
        super(name, Double.POSITIVE_INFINITY);
        if (breathsBefore < 0 || !(holdS > 0) || Double.isInfinite(holdS)) {
            throw new IllegalArgumentException("breath hold: breaths_before " + breathsBefore + " and hold_s " + holdS
                    + ", expected at least 0 breaths and more than 0 s");
        }
        if (!(creepFraction >= 0) || !(creepFraction < 1)) {
            throw new IllegalArgumentException(
                    "breath hold: creep_fraction " + creepFraction + ", expected from 0 to below 1");
        }
        this.around = new PeriodicPattern(name, around);
        this.breathsBefore = breathsBefore;
        this.holdS = holdS;
        startS = breathsBefore * around.periodS();
        atInspiration = held != null;
        BreathingParameters breath = atInspiration ? held : around;
        wave = breath.wave();
        drive = new RespiratoryDrive(breath);
        heldPeriodS = atInspiration ? breath.periodS() : 0;
        inspirationS = heldPeriodS * breath.inspiratoryFraction();
        resumeS = startS + heldPeriodS + holdS;
        creepRate = -StrictMath.log1p(-creepFraction) / effectiveHoldTime(CREEP_TIME_S);
    }

    /** Until the hold is over and one more breath has been taken. */
    @Override
    public double fullDurationS() {
        return resumeS + around.periodS();
    }

    @Override
    public void at(double timeS, BreathState state) {
        if (timeS < startS) {
            around.at(timeS, state);
        } else if (timeS >= resumeS) {
            around.at(timeS - resumeS, state);
            state.breath += breathsBefore + 1;
        } else {
            hold(timeS - startS, state);
        }
    }

    private void hold(double timeS, BreathState state) {
        state.breath = breathsBefore;
        state.phase = timeS / (resumeS - startS);
        if (!atInspiration) {
            state.setAtRest(RespiratoryPhase.HOLD);
            return;
        }
        // The breath's own clock stands still while it is held.
        double heldS = timeS - inspirationS;
        boolean holding = heldS > 0 && heldS < holdS;
        double clockS = holding ? inspirationS : heldS <= 0 ? timeS : timeS - holdS;
        double phase = clockS / heldPeriodS;
        double depth = wave.value(phase);
        double rate = holding ? 0 : wave.slope(phase) / heldPeriodS;
        drive.write(depth, rate, state);
        state.respiratoryPhase = holding ? RespiratoryPhase.HOLD : wave.respiratoryPhase(phase);
        if (heldS > 0) {
            double left = StrictMath.exp(-creepRate * effectiveHoldTime(heldS));
            double leftRate = -creepRate * Math.min(1, heldS / CREEP_ONSET_S) * left;
            state.activationRate = state.activationRate * left + state.activation * leftRate;
            state.activation *= left;
            state.pressure *= left;
        }
    }

    /** Time held, its first second eased in: the integral of {@code min(1, t / onset)}. */
    private static double effectiveHoldTime(double heldS) {
        return heldS < CREEP_ONSET_S ? heldS * heldS / (2 * CREEP_ONSET_S) : heldS - CREEP_ONSET_S / 2;
    }
}
