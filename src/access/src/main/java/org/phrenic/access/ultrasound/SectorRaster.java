package org.phrenic.access.ultrasound;

/**
 * Scan conversion: levels on scan lines become square pixels by bilinear interpolation. The sector fills a square
 * picture, its apex in the middle on top and the marker on the left.
 */
final class SectorRaster {
    final int size;
    final double mmPerPixel;
    private final double originColumn;
    private final double faceRow;
    private final int[] first;
    private final float[] lineShare;
    private final float[] sampleShare;

    SectorRaster(SectorGrid grid, int size) {
        this.size = size;
        double radius = grid.probe.radiusMm();
        double edge = Math.toRadians(0.5 * grid.probe.sectorDeg());
        double sagitta = radius * (1 - StrictMath.cos(edge));
        double width = 2 * (radius + grid.depthMm) * StrictMath.sin(edge);
        mmPerPixel = Math.max(width, grid.depthMm + sagitta) / (size - 1);
        originColumn = 0.5 * (size - 1);
        // The face's middle is the top of its arc in the body; the ends of the arc lie higher.
        faceRow = sagitta / mmPerPixel;
        first = new int[size * size];
        lineShare = new float[first.length];
        sampleShare = new float[first.length];
        for (int row = 0; row < size; row++) {
            for (int column = 0; column < size; column++) {
                double x = (originColumn - column) * mmPerPixel;
                double z = radius + (row - faceRow) * mmPerPixel;
                double line = grid.lineAt(x, z);
                double sample = (Math.sqrt(x * x + z * z) - radius) / grid.stepMm;
                int i = row * size + column;
                boolean seen =
                        line >= 0 && line <= SectorGrid.LINES - 1 && sample >= 0 && sample <= SectorGrid.SAMPLES - 1;
                int lower = Math.min((int) line, SectorGrid.LINES - 2);
                int upper = Math.min((int) sample, SectorGrid.SAMPLES - 2);
                first[i] = seen ? lower * SectorGrid.SAMPLES + upper : -1;
                lineShare[i] = (float) (line - lower);
                sampleShare[i] = (float) (sample - upper);
            }
        }
    }

    /** Column and row of a point of the image plane, from its lateral and axial probe coordinates, mm. */
    double[] pixel(double lateral, double axial) {
        return new double[] {originColumn - lateral / mmPerPixel, faceRow + axial / mmPerPixel};
    }

    /** Fills a picture row by row from levels of 0 to 255; black outside of the sector. */
    byte[] convert(float[] levels, int threads) {
        byte[] out = new byte[size * size];
        Bands.run(size, threads, (from, to) -> {
            for (int i = from * size; i < to * size; i++) {
                int k = first[i];
                if (k >= 0) {
                    float a = levels[k] + sampleShare[i] * (levels[k + 1] - levels[k]);
                    int n = k + SectorGrid.SAMPLES;
                    float b = levels[n] + sampleShare[i] * (levels[n + 1] - levels[n]);
                    out[i] = (byte) (int) (a + lineShare[i] * (b - a) + 0.5f);
                }
            }
        });
        return out;
    }
}
