package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.Smootherstep;

/**
 * Periodic coughs, one per period: an inspiration, about 0.2 s of compression against the closed glottis by the
 * abdominal muscles, then expulsion, in which the diaphragm relaxes and abdominal pressure pushes its domes up.
 *
 * <p>Phases: inspiration (drive and ribs rise), compression (both are held, abdominal pressure rises), expulsion (drive
 * falls in the first half, ribs fall throughout, pressure is held for the first half), recovery as long as the
 * expulsion (pressure falls), then rest until the end of the period.
 */
public final class CoughPattern extends PatternOfPeriod {
    private final RespiratoryDrive drive;
    private final double inspirationS;
    private final double compressionS;
    private final double expulsionS;
    private final double abdominalPressure;

    /**
     * @param parameters depth of the inspiration and rate of the coughs; Ti is its inspiratory fraction of the period
     * @param compressionS time with closed glottis, s
     * @param expulsionS time with open glottis, s
     * @param abdominalPressure peak abdominal pressure as a fraction of the maximum, 0 to 1
     */
    public CoughPattern(
            BreathingParameters parameters, double compressionS, double expulsionS, double abdominalPressure) {
        super(parameters.periodS());
        BreathingParameters.requireShare("abdominal_pressure", abdominalPressure);
        this.drive = new RespiratoryDrive(parameters);
        double periodS = parameters.periodS();
        this.inspirationS = parameters.inspiratoryFraction() * periodS;
        this.compressionS = compressionS;
        this.expulsionS = expulsionS;
        this.abdominalPressure = abdominalPressure;
        double cough = inspirationS + compressionS + 2 * expulsionS;
        if (!(compressionS > 0) || !(expulsionS > 0) || !(cough <= periodS)) {
            String found = "inspiration " + inspirationS + " s, compression_s " + compressionS + " and expulsion_s "
                    + expulsionS;
            throw new IllegalArgumentException(
                    "cough: " + found + ", expected more than 0 and inspiration, compression and twice the"
                            + " expulsion within the period of " + periodS + " s");
        }
    }

    /** Inspiration, compression, expulsion with recovery, and rest. */
    @Override
    public double[] stretchesS() {
        double compressedS = inspirationS + compressionS;
        return new double[] {inspirationS, compressedS, compressedS + 2 * expulsionS, periodS()};
    }

    @Override
    public void at(double timeS, BreathState state) {
        state.setPlace(timeS, periodS());
        double t = state.phase * periodS();
        double compressed = t - inspirationS;
        double expelled = compressed - compressionS;

        double fallS = expulsionS / 2;
        double in = Smootherstep.value(t / inspirationS);
        double inRate = Smootherstep.slope(t / inspirationS) / inspirationS;
        // Inspiration and expiration do not overlap, so that their difference is the depth.
        drive.write(
                in - Smootherstep.value(expelled / fallS),
                inRate - Smootherstep.slope(expelled / fallS) / fallS,
                state);
        drive.writeRibTurn(
                in - Smootherstep.value(expelled / expulsionS),
                inRate - Smootherstep.slope(expelled / expulsionS) / expulsionS,
                state);
        state.abdominalPressure = abdominalPressure
                * (Smootherstep.value(compressed / compressionS)
                        - Smootherstep.value((expelled - fallS) / (2 * expulsionS - fallS)));
        state.respiratoryPhase = timeS < 0 || expelled >= 2 * expulsionS
                ? RespiratoryPhase.PAUSE
                : compressed < 0
                        ? RespiratoryPhase.INSPIRATION
                        : expelled < 0 ? RespiratoryPhase.HOLD : RespiratoryPhase.EXPIRATION;
    }
}
