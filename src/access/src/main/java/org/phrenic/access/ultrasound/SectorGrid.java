package org.phrenic.access.ultrasound;

/**
 * Scan lines and samples of a {@link CurvilinearProbe}: line i at an angle from the central one, positive toward the
 * marker; sample s at the depth {@code s * stepMm}. In plane coordinates (x lateral, z axial) the origin is the centre
 * of the face's arc.
 */
final class SectorGrid {
    static final int LINES = 256;
    static final int SAMPLES = 512;

    final CurvilinearProbe probe;
    final double depthMm;
    final double stepMm;
    final double[] sin = new double[LINES];
    final double[] cos = new double[LINES];
    private final double firstRad;
    private final double spacingRad;

    SectorGrid(CurvilinearProbe probe, double depthMm) {
        this.probe = probe;
        this.depthMm = depthMm;
        stepMm = depthMm / (SAMPLES - 1);
        firstRad = -0.5 * StrictMath.toRadians(probe.sectorDeg());
        spacingRad = -2 * firstRad / (LINES - 1);
        for (int i = 0; i < LINES; i++) {
            sin[i] = StrictMath.sin(angle(i));
            cos[i] = StrictMath.cos(angle(i));
        }
    }

    double angle(double line) {
        return firstRad + line * spacingRad;
    }

    /** Line through a point in plane coordinates; between lines a fraction. */
    double lineAt(double x, double z) {
        return (StrictMath.atan2(x, z) - firstRad) / spacingRad;
    }

    /** Distance between neighbouring lines at a depth, mm. */
    double lineSpacingMm(double depth) {
        return (probe.radiusMm() + depth) * spacingRad;
    }

    /** Left of a line: positive toward the marker, zero on it. */
    double side(int line, double x, double z) {
        return x * cos[line] - z * sin[line];
    }

    /** First line of those that may pass between two points in front of the arc's centre. */
    int firstLine(double x0, double z0, double x1, double z1) {
        return Math.max(0, lowBound(Math.min(x0 / z0, x1 / z1)) - 1);
    }

    /** Line after the last of those that may pass between two points in front of the arc's centre. */
    int endLine(double x0, double z0, double x1, double z1) {
        return Math.min(LINES, lowBound(Math.max(x0 / z0, x1 / z1)) + 1);
    }

    /** The first line whose tangent is not below a value. */
    private int lowBound(double tangent) {
        int low = 0;
        int high = LINES;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sin[middle] < tangent * cos[middle]) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
