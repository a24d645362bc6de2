package org.phrenic.breathing;

import org.phrenic.engine.kinematics.SaturatingAmplitude;

/**
 * From the depth of a breath to what is asked of the thorax: muscle and pressure in proportion, the turn of the ribs along the
 * saturating curve, so that deep breaths turn them mostly at their beginning.
 */
final class Drive {
    private static final SaturatingAmplitude RIBS = SaturatingAmplitude.DEFAULT;

    private final double activation;
    private final double pressure;
    private final double volume;

    Drive(BreathingParameters parameters) {
        activation = parameters.activationPeak();
        pressure = parameters.pressurePeak();
        volume = RIBS.volume(parameters.ribTurnPeak());
    }

    /**
     * Writes all but phase, count and label.
     *
     * @param depth 0 end-expiration, 1 the end-inspiration of the parameters
     * @param rate its derivative, 1/s
     */
    void write(double depth, double rate, BreathState state) {
        state.activation = activation * depth;
        state.activationRate = activation * rate;
        state.pressure = pressure * depth;
        state.abdominalPressure = 0;
        turnRibs(depth, rate, state);
    }

    /** Writes the ribs alone. */
    void turnRibs(double depth, double rate, BreathState state) {
        state.ribTurn = RIBS.at(volume * depth);
        state.ribTurnRate = RIBS.slope(volume * depth) * volume * rate;
    }

    /** Depth of full activation and full turn, whichever is less: no deeper than the body goes. */
    double deepest() {
        return 1 / Math.max(Math.max(activation, pressure), Math.max(volume, Double.MIN_NORMAL));
    }
}
