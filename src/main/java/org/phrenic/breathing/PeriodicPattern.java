package org.phrenic.breathing;

/** The same breath again and again: quiet, deep, rapid and shallow, sniffs. */
public final class PeriodicPattern implements BreathingPattern {
    private final String name;
    private final double periodS;
    private final BreathWave wave;
    private final Drive drive;

    /** Breaths of these parameters. */
    public PeriodicPattern(String name, BreathingParameters parameters) {
        this.name = name;
        periodS = parameters.periodS();
        wave = parameters.wave();
        drive = new Drive(parameters);
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public double periodS() {
        return periodS;
    }

    @Override
    public void at(double timeS, BreathState state) {
        state.place(timeS, periodS);
        state.label = timeS < 0 ? BreathLabel.PAUSE : wave.label(state.phase);
        drive.write(wave.value(state.phase), wave.slope(state.phase) / periodS, state);
    }
}
