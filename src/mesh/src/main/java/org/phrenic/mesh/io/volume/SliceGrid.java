package org.phrenic.mesh.io.volume;

import org.phrenic.mesh.io.raster.VolumeAxes;

/**
 * A grid of slices on which contours are drawn.
 *
 * @param axes positions of its voxels in LPS and mm
 */
record SliceGrid(int columns, int rows, int slices, VolumeAxes axes) {
    /** Coordinate of a point along columns (0), rows (1) or slices (2), in voxels; axes are at right angles. */
    double index(int direction, double x, double y, double z) {
        double[] step = axes.steps()[direction];
        double[] origin = axes.origin();
        double along = (x - origin[0]) * step[0] + (y - origin[1]) * step[1] + (z - origin[2]) * step[2];
        return along / (step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
    }
}
