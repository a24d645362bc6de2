package org.phrenic.mesh.voxel;

/**
 * A box of voxels with a real value each, such as a CT in Hounsfield units. Voxel (i, j, k) has the index {@code i +
 * columns (j + rows k)}, and its centre is at
 *
 * <pre>
 * x = m0 i + m1 j + m2 k + m3,   y = m4 i + m5 j + m6 k + m7,   z = m8 i + m9 j + m10 k + m11   (mm)
 * </pre>
 *
 * Values are single precision, which holds whole numbers up to 2^24 exactly. The array of values is shared, not copied,
 * and must not be modified.
 */
public final class ImageGrid {
    private final int columns;
    private final int rows;
    private final int slices;
    private final float[] values;
    private final double[] toMm;

    /**
     * @param values one a voxel, in the order of voxel indices
     * @param toMm affine matrix m0 to m11, three rows of four numbers, as above
     * @throws IllegalArgumentException if sizes do not match
     */
    public ImageGrid(int columns, int rows, int slices, float[] values, double[] toMm) {
        long voxels = (long) columns * rows * slices;
        if (columns < 1 || rows < 1 || slices < 1 || voxels != values.length || toMm.length != 12) {
            throw new IllegalArgumentException(columns + " x " + rows + " x " + slices + " voxels, " + values.length
                    + " values and an affine of " + toMm.length + " numbers, expected as many values and 12 numbers");
        }
        this.columns = columns;
        this.rows = rows;
        this.slices = slices;
        this.values = values;
        this.toMm = toMm.clone();
    }

    public int columns() {
        return columns;
    }

    public int rows() {
        return rows;
    }

    public int slices() {
        return slices;
    }

    /** Values in the order of voxel indices; shared. */
    public float[] values() {
        return values;
    }

    /** Value of voxel (i, j, k). */
    public float value(int i, int j, int k) {
        return values[i + columns * (j + rows * k)];
    }

    /** The affine matrix m0 to m11 from voxel indices to mm, three rows of four numbers. */
    public double[] toMm() {
        return toMm.clone();
    }

    /** Converts voxel coordinates to a position in mm, written to {@code out}. */
    public void voxelToMm(double i, double j, double k, double[] out) {
        VoxelBox.apply(toMm, i, j, k, out);
    }

    @Override
    public String toString() {
        return "ImageGrid[" + columns + " x " + rows + " x " + slices + "]";
    }
}
