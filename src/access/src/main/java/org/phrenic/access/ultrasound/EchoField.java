package org.phrenic.access.ultrasound;

import java.util.Arrays;

/**
 * Echoes of all scan lines before they are blurred across the lines: complex amplitudes of the scatterers, amplitudes
 * of interfaces already shaped as pulses, and the amplitude that an echo from the image plane keeps, all relative to a
 * perfect mirror in front of the face.
 */
final class EchoField {
    private static final int PULSE_TABLE_PER_SIGMA = 256;
    private static final int PULSE_SIGMAS = 4;
    /** From full width at half maximum to standard deviation: 2 sqrt(2 ln 2). */
    static final double WIDTH_PER_SIGMA = 2.3548200450309493;

    final float[] real = new float[SectorGrid.LINES * SectorGrid.SAMPLES];
    final float[] imaginary = new float[real.length];
    final float[] interfaces = new float[real.length];
    final float[] kept = new float[real.length];
    private final SectorGrid grid;
    private final double sigmaMm;
    private final double areaMm;
    private final float[] pulse = new float[PULSE_SIGMAS * PULSE_TABLE_PER_SIGMA + 2];

    EchoField(SectorGrid grid) {
        this.grid = grid;
        sigmaMm = grid.probe.axialWidthMm() / WIDTH_PER_SIGMA;
        areaMm = sigmaMm * Math.sqrt(2 * Math.PI);
        for (int i = 0; i < pulse.length; i++) {
            double x = (double) i / PULSE_TABLE_PER_SIGMA;
            pulse[i] = (float) StrictMath.exp(-0.5 * x * x);
        }
    }

    void clear(int line) {
        int from = line * SectorGrid.SAMPLES;
        int to = from + SectorGrid.SAMPLES;
        Arrays.fill(real, from, to, 0);
        Arrays.fill(imaginary, from, to, 0);
        Arrays.fill(interfaces, from, to, 0);
        Arrays.fill(kept, from, to, 0);
    }

    /**
     * Adds the echo of an interface.
     *
     * @param extentMm range of depths over which the interface extends within its part of the beam. Where it is longer
     *     than the pulse, the echo is spread over it, and its amplitude divided.
     */
    void addEcho(int line, double depthMm, double amplitude, double extentMm) {
        double half = 0.5 * extentMm;
        double peak = amplitude * Math.min(1, areaMm / Math.max(areaMm, extentMm));
        int row = line * SectorGrid.SAMPLES;
        double reach = half + PULSE_SIGMAS * sigmaMm;
        int from = Math.max(0, (int) Math.ceil((depthMm - reach) / grid.stepMm));
        int to = Math.min(SectorGrid.SAMPLES - 1, (int) Math.floor((depthMm + reach) / grid.stepMm));
        for (int s = from; s <= to; s++) {
            double beyond = Math.max(0, Math.abs(s * grid.stepMm - depthMm) - half);
            double at = beyond / sigmaMm * PULSE_TABLE_PER_SIGMA;
            int i = Math.min((int) at, pulse.length - 2);
            double share = at - i;
            interfaces[row + s] += (float) (peak * (pulse[i] + share * (pulse[i + 1] - pulse[i])));
        }
    }

    /**
     * Adds what comes back a second time from between the face and a strong reflector: the line's echoes again, shifted
     * by the depth of the reflector, and so on.
     */
    void reverberate(int line, double depthMm, double factor) {
        int shift = (int) Math.round(depthMm / grid.stepMm);
        if (shift < 2) {
            return;
        }
        float f = (float) factor;
        int row = line * SectorGrid.SAMPLES;
        for (int s = shift; s < SectorGrid.SAMPLES; s++) {
            real[row + s] += f * real[row + s - shift];
            imaginary[row + s] += f * imaginary[row + s - shift];
            interfaces[row + s] += f * interfaces[row + s - shift];
        }
    }
}
