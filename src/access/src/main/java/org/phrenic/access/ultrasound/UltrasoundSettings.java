package org.phrenic.access.ultrasound;

/**
 * Controls of an ultrasound scanner.
 *
 * @param depthMm depth of the image, mm
 * @param gainDb overall gain, dB
 * @param depthGainDbPerCmMhz time-gain compensation: the attenuation that it makes up for, dB/cm at 1 MHz
 * @param dynamicRangeDb range of intensities from black to white, dB
 */
public record UltrasoundSettings(double depthMm, double gainDb, double depthGainDbPerCmMhz, double dynamicRangeDb) {
    /** Depth 150 mm, gain 0 dB, compensation of 0.5 dB/cm at 1 MHz, range 60 dB. */
    public static final UltrasoundSettings DEFAULT = new UltrasoundSettings(150, 0, 0.5, 60);

    public static final double LEAST_DEPTH_MM = 40;
    public static final double GREATEST_DEPTH_MM = 300;

    public UltrasoundSettings {
        if (!(depthMm >= LEAST_DEPTH_MM && depthMm <= GREATEST_DEPTH_MM)) {
            throw new IllegalArgumentException("ultrasound: found a depth of " + depthMm + " mm, expected "
                    + LEAST_DEPTH_MM + " to " + GREATEST_DEPTH_MM);
        }
        if (!(Math.abs(gainDb) <= 100 && depthGainDbPerCmMhz >= 0 && dynamicRangeDb > 0)) {
            throw new IllegalArgumentException("ultrasound: found gain " + gainDb + " dB, depth gain "
                    + depthGainDbPerCmMhz + " dB/cm/MHz, dynamic range " + dynamicRangeDb
                    + " dB, expected a gain within 100 dB and the others not negative");
        }
    }

    public UltrasoundSettings withDepth(double mm) {
        return new UltrasoundSettings(mm, gainDb, depthGainDbPerCmMhz, dynamicRangeDb);
    }

    public UltrasoundSettings withDepthGain(double dbPerCmMhz) {
        return new UltrasoundSettings(depthMm, gainDb, dbPerCmMhz, dynamicRangeDb);
    }

    public UltrasoundSettings withGain(double db) {
        return new UltrasoundSettings(depthMm, db, depthGainDbPerCmMhz, dynamicRangeDb);
    }
}
