package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathWaveform;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.RespiratoryPhase;

/** Identical periodic breaths, such as quiet, deep, rapid shallow breathing or sniffs. */
public final class PeriodicPattern extends PatternOfPeriod {
    private final BreathWaveform wave;
    private final RespiratoryDrive drive;

    public PeriodicPattern(BreathingParameters parameters) {
        super(parameters.periodS());
        wave = parameters.wave();
        drive = new RespiratoryDrive(parameters);
    }

    @Override
    public void at(double timeS, BreathState state) {
        state.setPlace(timeS, periodS());
        state.respiratoryPhase = timeS < 0 ? RespiratoryPhase.PAUSE : wave.respiratoryPhase(state.phase);
        drive.write(wave.value(state.phase), wave.slope(state.phase) / periodS(), state);
    }
}
