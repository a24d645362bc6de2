package org.phrenic.access.ultrasound;

/**
 * A curvilinear ultrasound probe: scan lines leave a cylindrical face at right angles. Widths of the beam are full
 * widths at half of the amplitude:
 *
 * <ul>
 *   <li>along the line: half of a pulse of 2.5 wavelengths;
 *   <li>across it in the image: {@code wavelength max(2, d / aperture)} of a receiver that follows the echo's depth d
 *       with an aperture of {@value #APERTURE_MM} mm, widened by {@value #DEFOCUS} of the distance from the focus of
 *       the transmitted beam;
 *   <li>across the image plane (elevation): {@code sqrt(t^2 + (}{@value #ELEVATION_SLOPE}{@code (d - f))^2)}, with the
 *       thickness t at the focus f of the fixed lens.
 * </ul>
 *
 * @param radiusMm radius of the face, mm
 * @param sectorDeg angle between the outermost scan lines, degrees
 * @param frequencyMhz centre frequency, MHz
 * @param focusMm depth of the focus, mm
 * @param thicknessMm thickness of the beam at the focus, mm
 */
public record CurvilinearProbe(
        double radiusMm, double sectorDeg, double frequencyMhz, double focusMm, double thicknessMm) {
    /** Speed of sound in soft tissue by which scanners turn time into depth, mm/us. */
    public static final double SPEED_MM_PER_US = 1.54;

    private static final double PULSE_WAVELENGTHS = 2.5;
    private static final double APERTURE_MM = 20;
    private static final double LEAST_F_NUMBER = 2;
    private static final double DEFOCUS = 0.015;
    private static final double ELEVATION_SLOPE = 0.05;

    public CurvilinearProbe {
        if (!(radiusMm > 0 && sectorDeg > 0 && sectorDeg < 120 && focusMm > 0 && thicknessMm > 0)) {
            throw new IllegalArgumentException("probe: found radius " + radiusMm + " mm, sector " + sectorDeg
                    + " degrees, focus " + focusMm + " mm, thickness " + thicknessMm
                    + " mm, expected positive numbers and a sector below 120 degrees");
        }
        if (!(frequencyMhz >= 1 && frequencyMhz <= 15)) {
            throw new IllegalArgumentException("probe: found " + frequencyMhz + " MHz, expected 1 to 15");
        }
    }

    /** A probe for the abdomen of adults: 3.5 MHz, radius 55 mm, sector 65 degrees. */
    public static CurvilinearProbe abdominal() {
        return new CurvilinearProbe(55, 65, 3.5, 80, 3.5);
    }

    /** Wavelength in soft tissue, mm. */
    public double wavelengthMm() {
        return SPEED_MM_PER_US / frequencyMhz;
    }

    /** Width of the point spread along the scan line, mm. */
    public double axialWidthMm() {
        return PULSE_WAVELENGTHS / 2 * wavelengthMm();
    }

    /** Width of the point spread across the scan line in the image plane at a depth, mm. */
    public double lateralWidthMm(double depthMm) {
        double received = wavelengthMm() * Math.max(LEAST_F_NUMBER, depthMm / APERTURE_MM);
        double defocus = DEFOCUS * (depthMm - focusMm);
        return Math.sqrt(received * received + defocus * defocus);
    }

    /** Thickness of the beam across the image plane at a depth, mm. */
    public double elevationWidthMm(double depthMm) {
        double defocus = ELEVATION_SLOPE * (Math.max(0, depthMm) - focusMm);
        return Math.sqrt(thicknessMm * thicknessMm + defocus * defocus);
    }

    /**
     * Relative amplitude across the beam: {@code cos^2(pi y / 2 w)} within w on either side of the image plane, so that
     * w is the full width at half of the amplitude, and none beyond.
     *
     * @param elevationMm distance y from the image plane, mm
     * @param depthMm depth at which the width w is taken, mm
     */
    public double elevationProfile(double elevationMm, double depthMm) {
        double relative = Math.abs(elevationMm) / elevationWidthMm(depthMm);
        if (relative >= 1) {
            return 0;
        }
        double cosine = StrictMath.cos(0.5 * Math.PI * relative);
        return cosine * cosine;
    }
}
