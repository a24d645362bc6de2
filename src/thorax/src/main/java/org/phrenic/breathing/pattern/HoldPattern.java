package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathWaveform;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * Breathing with one breath hold.
 *
 * <p>During a hold at inspiration the diaphragm slowly moves up: its drive decays as {@code exp(-lambda g)}, where
 * {@code g} is the time held (with a smooth first second), and loses the creep fraction in {@value #CREEP_TIME_S} s.
 * Measured in 15 people: up to 5.6 mm cranial displacement in 24 s and 123 ml less lung volume (PMC7055431). The ribs
 * do not move. During a hold at expiration everything is at rest and nothing creeps.
 */
public final class HoldPattern extends PatternOfPeriod {
    /** Hold time for which the creep fraction is given, s. */
    public static final double CREEP_TIME_S = 24;

    /** Time over which creep sets in, s, so that the hold begins smoothly. */
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
     * @param around parameters of the breaths before and after the hold
     * @param breathsBefore number of breaths before the hold
     * @param held parameters of the held breath: its depth, and the rate and fractions of its inspiration and
     *     expiration; null to hold at end-expiration
     * @param holdS duration of the hold, s, above 0
     * @param creepFraction fraction of the drive lost in {@value #CREEP_TIME_S} s, at least 0 and below 1
     */
    public HoldPattern(
            BreathingParameters around,
            int breathsBefore,
            BreathingParameters held,
            double holdS,
            double creepFraction) {
        super(Double.POSITIVE_INFINITY);
        if (breathsBefore < 0 || !(holdS > 0) || Double.isInfinite(holdS)) {
            throw new IllegalArgumentException("breath hold: breaths_before " + breathsBefore + " and hold_s " + holdS
                    + ", expected at least 0 breaths and more than 0 s");
        }
        if (!(creepFraction >= 0) || !(creepFraction < 1)) {
            throw new IllegalArgumentException(
                    "breath hold: creep_fraction " + creepFraction + ", expected from 0 to below 1");
        }
        this.around = new PeriodicPattern(around);
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

    /** Duration up to the end of the hold and one further breath. */
    @Override
    public double fullDurationS() {
        return resumeS + around.periodS();
    }

    /** Breaths before, inspiration of the held breath, hold, its expiration, and one breath after. */
    @Override
    public double[] stretchesS() {
        double heldS = startS + inspirationS;
        return new double[] {startS, heldS, heldS + holdS, resumeS, resumeS + around.periodS()};
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
        // Time within the breath stands still during the hold.
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

    /** Time held, with a smooth first second: the integral of {@code min(1, t / onset)}. */
    private static double effectiveHoldTime(double heldS) {
        return heldS < CREEP_ONSET_S ? heldS * heldS / (2 * CREEP_ONSET_S) : heldS - CREEP_ONSET_S / 2;
    }
}
