package org.phrenic.mesh.voxel;

import org.phrenic.mesh.Vectors;

/**
 * A plane at which the end of a scan truncates structures, {@code n . p = offset} with the unit normal n = (x, y, z)
 * out of the scan. The grid of a scan may be rotated relative to LPS.
 *
 * @param side letter of the side of the body (L R P A S I) toward which the normal points most
 * @param offsetMm distance of the plane from the origin along the normal, mm
 */
public record CutPlane(String side, double x, double y, double z, double offsetMm) {
    /**
     * The outer face of the first or last layer of voxels.
     *
     * @param toMm affine transform from voxel indices to LPS, mm, row by row
     * @param direction direction of the grid across the layer
     * @param layer index of the layer
     * @param forward whether the scan ends in this direction, or in the opposite one
     */
    public static CutPlane ofLayer(double[] toMm, int direction, int layer, boolean forward) {
        double[] normal = {toMm[direction], toMm[4 + direction], toMm[8 + direction]};
        double length = Vectors.length(normal);
        double offset = (forward ? layer + 0.5 : 0.5 - layer) * length;
        int largest = 0;
        for (int row = 0; row < 3; row++) {
            normal[row] *= (forward ? 1 : -1) / length;
            offset += normal[row] * toMm[4 * row + 3];
            largest = Math.abs(normal[row]) > Math.abs(normal[largest]) ? row : largest;
        }
        char letter = (normal[largest] > 0 ? "LPS" : "RAI").charAt(largest);
        return new CutPlane(String.valueOf(letter), normal[0], normal[1], normal[2], offset);
    }

    /** Whether a point lies beyond the plane, or nearer to it than a distance. */
    public boolean isReachedBy(double[] points, int at, double distanceMm) {
        return x * points[at] + y * points[at + 1] + z * points[at + 2] > offsetMm - distanceMm;
    }

    /** Distance of a point from the plane, mm; positive within the scan. */
    public double depth(double[] p) {
        return offsetMm - x * p[0] - y * p[1] - z * p[2];
    }

    /** A point moved along the normal. */
    public double[] moved(double[] p, double mm) {
        return new double[] {p[0] + mm * x, p[1] + mm * y, p[2] + mm * z};
    }
}
