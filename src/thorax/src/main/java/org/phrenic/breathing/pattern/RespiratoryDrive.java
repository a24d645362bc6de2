package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.engine.kinematics.SaturatingAmplitude;

/**
 * Maps the depth of a breath to activation, pressure and rib rotation, all along the same saturating curve. Deep
 * breaths therefore rotate the ribs mostly at their beginning. If activation were proportional to depth, the dome would
 * descend mostly at the end of a deep breath, when the ribs have almost stopped. In people its descent is proportional
 * to the inspired volume (Houston et al. 1994, PMID 7940428: linear, r of 0.976 or more).
 */
final class RespiratoryDrive {
    private static final SaturatingAmplitude CURVE = SaturatingAmplitude.DEFAULT;

    private final double activation;
    private final double pressure;
    private final double volume;
    /** Argument of the saturating curve at end-inspiration. */
    private final double effort;

    RespiratoryDrive(BreathingParameters parameters) {
        activation = parameters.activationPeak();
        pressure = parameters.pressurePeak();
        volume = CURVE.volume(parameters.ribTurnPeak());
        effort = CURVE.volume(activation);
    }

    /**
     * Writes all fields except phase, breath count and respiratory phase.
     *
     * @param depth 0 at end-expiration, 1 at the end-inspiration of the parameters
     * @param rate time derivative of the depth, 1/s
     */
    void write(double depth, double rate, BreathState state) {
        state.activation = CURVE.at(effort * depth);
        state.activationRate = CURVE.slope(effort * depth) * effort * rate;
        state.pressure = activation > 0 ? pressure * state.activation / activation : pressure * depth;
        state.abdominalPressure = 0;
        writeRibTurn(depth, rate, state);
    }

    /** Writes rib rotation and its rate only. */
    void writeRibTurn(double depth, double rate, BreathState state) {
        state.ribTurn = CURVE.at(volume * depth);
        state.ribTurnRate = CURVE.slope(volume * depth) * volume * rate;
    }

    /**
     * Largest possible depth: the least of those of full activation, of full rib rotation and of the full pressure,
     * taken to rise in proportion to the depth.
     */
    double maxDepth() {
        return 1 / Math.max(Math.max(effort, pressure), Math.max(volume, Double.MIN_NORMAL));
    }
}
