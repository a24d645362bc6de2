package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathWaveform;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * Cheyne-Stokes breathing: cycles of waxing and waning breaths, each followed by an apnoea.
 *
 * <p>Breath {@code k} (from 0) of the {@code n} breaths of a cycle has the relative depth {@code sin^2(pi (k + 1/2) /
 * n)}. Each breath begins and ends at end-expiration, so that changes of depth cause no discontinuity.
 */
public final class CheyneStokesPattern extends PatternOfPeriod {
    private final double oneBreathS;
    private final double[] depths;
    private final BreathWaveform wave;
    private final RespiratoryDrive drive;

    /**
     * @param deepest parameters of a breath of relative depth 1; its rate applies to all breaths
     * @param breaths number of breaths in a cycle, at least 1
     * @param apnoeaS duration of the apnoea after them, s, at least 0
     */
    public CheyneStokesPattern(BreathingParameters deepest, int breaths, double apnoeaS) {
        super(breaths * deepest.periodS() + apnoeaS);
        if (breaths < 1 || !(apnoeaS >= 0) || Double.isInfinite(apnoeaS)) {
            throw new IllegalArgumentException("waxing and waning: breaths " + breaths + " and apnoea_s " + apnoeaS
                    + ", expected at least 1 breath and at least 0 s");
        }
        oneBreathS = deepest.periodS();
        wave = deepest.wave();
        drive = new RespiratoryDrive(deepest);
        depths = new double[breaths];
        for (int k = 0; k < breaths; k++) {
            double sine = StrictMath.sin(Math.PI * (k + 0.5) / breaths);
            depths[k] = sine * sine;
        }
    }

    /** Breaths and apnoea. */
    @Override
    public double[] stretchesS() {
        return new double[] {depths.length * oneBreathS, periodS()};
    }

    @Override
    public void at(double timeS, BreathState state) {
        double cycles = Math.max(0, timeS / periodS());
        int cycle = (int) cycles;
        double breaths = (cycles - cycle) * periodS() / oneBreathS;
        int breath = (int) breaths;
        if (breath >= depths.length) {
            state.setAtRest(RespiratoryPhase.PAUSE);
            // The apnoea counts as part of the last breath.
            state.breath = (cycle + 1) * depths.length - 1;
            state.phase = 0;
            return;
        }
        state.breath = cycle * depths.length + breath;
        state.phase = breaths - breath;
        state.respiratoryPhase = timeS < 0 ? RespiratoryPhase.PAUSE : wave.respiratoryPhase(state.phase);
        drive.write(
                depths[breath] * wave.value(state.phase), depths[breath] * wave.slope(state.phase) / oneBreathS, state);
    }
}
