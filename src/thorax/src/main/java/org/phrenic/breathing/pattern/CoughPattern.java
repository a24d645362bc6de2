package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.Smootherstep;

/**
 * Coughs, one a period: a breath in, some 0.2 s against the closed glottis while the abdominal muscles press, then
 * expulsion, the diaphragm gives way and the pressure of the abdomen pushes its domes up.
 *
 * <p>Over the breath: inspiration (drive and ribs rise), compression (both stay, abdominal pressure rises), expulsion
 * (drive falls in its first half, ribs fall over all of it, pressure stays for its first half), then pressure falls
 * over a recovery as long as expulsion; rest to the end of the period.
 */
public final class CoughPattern extends NamedPattern {
    private final RespiratoryDrive drive;
    private final double inspirationS;
    private final double compressionS;
    private final double expulsionS;
    private final double abdominalPressure;

    /**
     * Coughs of a depth.
     *
     * @param name what to call it
     * @param parameters depth of the breath in; rate of the coughs; Ti is its inspiratory fraction of the period
     * @param compressionS glottis closed, s
     * @param expulsionS glottis open, s
     * @param abdominalPressure at the height of the cough, as a share of the greatest, 0 to 1
     */
    public CoughPattern(
            String name,
            BreathingParameters parameters,
            double compressionS,
            double expulsionS,
            double abdominalPressure) {
        super(name, parameters.periodS());
        BreathingParameters.requireShare("abdominal_pressure", abdominalPressure);
        this.drive = new RespiratoryDrive(parameters);
        double periodS = parameters.periodS();
        this.inspirationS = parameters.inspiratoryFraction() * periodS;
        this.compressionS = compressionS;
        this.expulsionS = expulsionS;
        this.abdominalPressure = abdominalPressure;
        double cough = inspirationS + compressionS + 2 * expulsionS;
        if (!(compressionS > 0) || !(expulsionS > 0) || !(cough <= periodS)) {
            throw new IllegalArgumentException(
                    "cough: inspiration " + inspirationS + " s, compression_s " + compressionS
                            + " and expulsion_s " + expulsionS
                            + ", expected more than 0 and inspiration, compression and twice the expulsion within the "
                            + "period of "
                            + periodS + " s");
        }
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
        // In and out never overlap, so that their difference is the depth.
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
