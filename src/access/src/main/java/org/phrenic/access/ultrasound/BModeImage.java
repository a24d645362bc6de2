package org.phrenic.access.ultrasound;

/**
 * A B-mode ultrasound image of {@value #SIZE} x {@value #SIZE} pixels, and the intensities on the scan lines that it is
 * made of. The marker of the probe is on the left, the skin on top.
 */
public final class BModeImage {
    public static final int SIZE = 512;

    private final ProbePose pose;
    private final UltrasoundSettings settings;
    private final SectorGrid grid;
    private final SectorRaster raster;
    private final float[] intensity;
    private final byte[] grey;

    BModeImage(
            ProbePose pose,
            UltrasoundSettings settings,
            SectorGrid grid,
            SectorRaster raster,
            float[] intensity,
            byte[] grey) {
        this.pose = pose;
        this.settings = settings;
        this.grid = grid;
        this.raster = raster;
        this.intensity = intensity;
        this.grey = grey;
    }

    public ProbePose pose() {
        return pose;
    }

    public UltrasoundSettings settings() {
        return settings;
    }

    public CurvilinearProbe probe() {
        return grid.probe;
    }

    /** Grey levels, row by row; shared, must not be modified. */
    public byte[] grey() {
        return grey;
    }

    /** Width and height of a pixel, mm. */
    public double mmPerPixel() {
        return raster.mmPerPixel;
    }

    /** Column and row at which a point is seen when it is projected onto the image plane. */
    public double[] pixelOf(double[] world) {
        double[] p = pose.toProbe(world);
        return raster.pixel(p[0], p[1]);
    }

    /** Whether a point is within half of the beam's thickness of the image plane, sector and depth. */
    public boolean isInBeam(double[] world) {
        return SonatedNeedle.isInBeam(world, probe(), pose, settings.depthMm());
    }

    /**
     * Intensity before compensation and compression, relative to a perfect mirror in front of the face, at the sample
     * nearest to a depth.
     */
    public double intensity(int line, double depthMm) {
        return intensity[line * SectorGrid.SAMPLES + (int) Math.round(depthMm / grid.stepMm)];
    }
}
