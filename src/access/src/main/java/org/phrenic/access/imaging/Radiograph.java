package org.phrenic.access.imaging;

/**
 * A radiograph: the attenuation {@code -ln(I / I0)} of the ray of each pixel of a {@link CArm}. {@link Fluoroscope}
 * takes it.
 */
public final class Radiograph {
    private final CArm arm;
    private final double[] attenuation;

    Radiograph(CArm arm, double[] attenuation) {
        this.arm = arm;
        this.attenuation = attenuation;
    }

    public CArm arm() {
        return arm;
    }

    /** Attenuation {@code -ln(I / I0)} of a pixel. */
    public double attenuation(int column, int row) {
        return attenuation[row * arm.columns() + column];
    }

    /**
     * Grey levels, row by row: linear in the attenuation, so bones are white and lungs dark.
     *
     * @param black attenuation of level 0
     * @param white attenuation of level 255
     */
    public byte[] grey(double black, double white) {
        byte[] levels = new byte[attenuation.length];
        for (int i = 0; i < levels.length; i++) {
            double level = 255 * (attenuation[i] - black) / (white - black);
            levels[i] = (byte) Math.round(Math.max(0, Math.min(255, level)));
        }
        return levels;
    }
}
