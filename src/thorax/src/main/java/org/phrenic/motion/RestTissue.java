package org.phrenic.motion;

import org.phrenic.mesh.voxel.VoxelBox;

/**
 * What an image of the body at rest shows at a place that lies in a region. Where the voxel that holds the place is of
 * the region, the image is read there, from voxels of the region alone. Else the field has led across the border of the
 * region, by less than a voxel where voxels are coarse, or by more where the model opens a gap that nothing has moved
 * into; then the nearest voxel of the region within {@value #REACH_MM} mm stands for the place, so that no region shows
 * the tissue of another.
 */
final class RestTissue {
    /** Deepest gap of the model with some to spare, mm. */
    private static final double REACH_MM = 20;

    private final int columns;
    private final int rows;
    private final int slices;
    private final byte[] regions;
    private final double[] spacing;
    private final int reach;

    /** @param regions region of each voxel at rest */
    RestTissue(VoxelBox box, byte[] regions) {
        columns = box.columns();
        rows = box.rows();
        slices = box.slices();
        this.regions = regions;
        spacing = new double[] {box.spacing(0), box.spacing(1), box.spacing(2)};
        reach = (int) Math.ceil(REACH_MM / Math.min(spacing[0], Math.min(spacing[1], spacing[2])));
    }

    /** Label of a region at a place in voxel coordinates; 0 beyond the image. */
    float label(float[] labels, int region, double x, double y, double z) {
        if (beyond(x, y, z)) {
            return 0;
        }
        int own = voxel(x, y, z);
        int nearest = holds(own, region) ? own : nearest(region, x, y, z);
        return labels[nearest < 0 ? own : nearest];
    }

    /**
     * Value of a region at a place in voxel coordinates, linear between its voxels; {@code beyond} beyond the image.
     */
    float value(float[] values, int region, double x, double y, double z, float beyond) {
        if (beyond(x, y, z)) {
            return beyond;
        }
        int own = voxel(x, y, z);
        if (holds(own, region)) {
            return linear(values, region, x, y, z);
        }
        int nearest = nearest(region, x, y, z);
        return nearest < 0 ? linear(values, Byte.toUnsignedInt(regions[own]), x, y, z) : values[nearest];
    }

    private boolean beyond(double x, double y, double z) {
        return !(x > -0.5 && y > -0.5 && z > -0.5) || x >= columns - 0.5 || y >= rows - 0.5 || z >= slices - 0.5;
    }

    private boolean holds(int voxel, int region) {
        return Byte.toUnsignedInt(regions[voxel]) == region;
    }

    private int index(int i, int j, int k) {
        return i + columns * (j + rows * k);
    }

    private int voxel(double x, double y, double z) {
        return index((int) Math.round(x), (int) Math.round(y), (int) Math.round(z));
    }

    /** The voxel of a region whose centre is nearest, the first of several; -1 for none within reach. */
    private int nearest(int region, double x, double y, double z) {
        int ci = (int) Math.round(x);
        int cj = (int) Math.round(y);
        int ck = (int) Math.round(z);
        double least = REACH_MM * REACH_MM;
        int found = -1;
        double edge = Math.min(spacing[0], Math.min(spacing[1], spacing[2]));
        // Voxels of layer n lie at least n - 1/2 edges away.
        for (int layer = 1; layer <= reach && (layer - 0.5) * edge * ((layer - 0.5) * edge) < least; layer++) {
            for (int k = Math.max(0, ck - layer); k <= Math.min(slices - 1, ck + layer); k++) {
                for (int j = Math.max(0, cj - layer); j <= Math.min(rows - 1, cj + layer); j++) {
                    boolean face = Math.abs(k - ck) == layer || Math.abs(j - cj) == layer;
                    int step = face ? 1 : 2 * layer;
                    for (int i = ci - layer; i <= ci + layer; i += step) {
                        if (i < 0 || i >= columns || !holds(index(i, j, k), region)) {
                            continue;
                        }
                        double square = square(0, i - x) + square(1, j - y) + square(2, k - z);
                        if (square < least) {
                            least = square;
                            found = index(i, j, k);
                        }
                    }
                }
            }
        }
        return found;
    }

    private double square(int direction, double voxels) {
        double mm = spacing[direction] * voxels;
        return mm * mm;
    }

    /** Linear between the voxels of a region that surround a place; it holds the nearest of them. */
    private float linear(float[] values, int region, double x, double y, double z) {
        double sum = 0;
        double weights = 0;
        double cx = Math.max(0, Math.min(columns - 1, x));
        double cy = Math.max(0, Math.min(rows - 1, y));
        double cz = Math.max(0, Math.min(slices - 1, z));
        int i = Math.min((int) cx, Math.max(0, columns - 2));
        int j = Math.min((int) cy, Math.max(0, rows - 2));
        int k = Math.min((int) cz, Math.max(0, slices - 2));
        for (int c = 0; c < 8; c++) {
            double w = ((c & 1) == 1 ? cx - i : 1 - cx + i)
                    * ((c >> 1 & 1) == 1 ? cy - j : 1 - cy + j)
                    * (c >> 2 == 1 ? cz - k : 1 - cz + k);
            int corner = w == 0 ? -1 : index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
            if (corner >= 0 && holds(corner, region)) {
                sum += w * values[corner];
                weights += w;
            }
        }
        return (float) (sum / weights);
    }
}
