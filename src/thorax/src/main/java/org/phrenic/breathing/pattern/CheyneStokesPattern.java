package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathWaveform;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * Cheyne-Stokes breathing: breaths that wax and wane, then none for a while, again and again.
 *
 * <p>Of the {@code n} breaths of a cycle, breath {@code k} (from 0) has the depth {@code sin^2(pi (k + 1/2) / n)} of
 * the deepest. Each begins and ends at end-expiration, so that the change of depth shows nowhere as a step.
 */
public final class CheyneStokesPattern extends NamedPattern {
    private final double oneBreathS;
    private final double[] depths;
    private final BreathWaveform wave;
    private final RespiratoryDrive drive;

    /**
     * Waxing and waning breaths.
     *
     * @param name what to call it
     * @param deepest the deepest breath; all have its rate
     * @param breaths in a cycle, at least 1
     * @param apnoeaS time without breaths after them, s, from 0
     */
    public CheyneStokesPattern(String name, BreathingParameters deepest, int breaths, double apnoeaS) {
        super(name, breaths * deepest.periodS() + apnoeaS);
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

    @Override
    public void at(double timeS, BreathState state) {
        double cycles = Math.max(0, timeS / periodS());
        int cycle = (int) cycles;
        double breaths = (cycles - cycle) * periodS() / oneBreathS;
        int breath = (int) breaths;
        if (breath >= depths.length) {
            state.setAtRest(RespiratoryPhase.PAUSE);
            // The apnoea belongs to the last breath.
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
