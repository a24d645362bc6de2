package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.engine.kinematics.SaturatingAmplitude;

/**
 * Maps the depth of a breath to activation, pressure and rotation of the ribs: the turn of the ribs along the
 * saturating curve, so that deep breaths turn them mostly at their beginning, and muscle and pressure along the same
 * curve. With muscle in proportion to the depth the dome would go down mostly at the end of a deep breath, when the
 * ribs have all but come to rest; in people it follows the inspired volume in proportion (Houston et al. 1994, PMID
 * 7940428: a straight line, r of 0.976 or more).
 */
final class RespiratoryDrive {
    private static final SaturatingAmplitude CURVE = SaturatingAmplitude.DEFAULT;

    private final double activation;
    private final double pressure;
    private final double volume;
    /** How far along the muscle's curve the end-inspiration is. */
    private final double effort;

    RespiratoryDrive(BreathingParameters parameters) {
        activation = parameters.activationPeak();
        pressure = parameters.pressurePeak();
        volume = CURVE.volume(parameters.ribTurnPeak());
        effort = CURVE.volume(activation);
    }

    /**
     * Writes all but phase, count and label.
     *
     * @param depth 0 end-expiration, 1 the end-inspiration of the parameters
     * @param rate its derivative, 1/s
     */
    void write(double depth, double rate, BreathState state) {
        state.activation = CURVE.at(effort * depth);
        state.activationRate = CURVE.slope(effort * depth) * effort * rate;
        state.pressure = activation > 0 ? pressure * state.activation / activation : pressure * depth;
        state.abdominalPressure = 0;
        writeRibTurn(depth, rate, state);
    }

    /** Writes the ribs alone. */
    void writeRibTurn(double depth, double rate, BreathState state) {
        state.ribTurn = CURVE.at(volume * depth);
        state.ribTurnRate = CURVE.slope(volume * depth) * volume * rate;
    }

    /** Depth of full activation and full turn, whichever is less: no deeper than the body goes. */
    double maxDepth() {
        return 1 / Math.max(Math.max(effort, pressure), Math.max(volume, Double.MIN_NORMAL));
    }
}
