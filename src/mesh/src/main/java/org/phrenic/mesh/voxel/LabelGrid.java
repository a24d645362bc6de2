package org.phrenic.mesh.voxel;

import java.util.Arrays;
import java.util.function.IntPredicate;
import org.phrenic.mesh.MeshMeasure;

/**
 * A box of voxels with labels from 0 (background) to 65535. Voxel (i, j, k) has the index {@code i + columns (j + rows
 * k)}, and its centre is at
 *
 * <pre>
 * x = m0 i + m1 j + m2 k + m3,   y = m4 i + m5 j + m6 k + m7,   z = m8 i + m9 j + m10 k + m11   (mm)
 * </pre>
 *
 * A label takes one byte, or two if any label is above 255. Arrays are shared, not copied, and must not be modified.
 */
public final class LabelGrid {
    /** The largest label. */
    public static final int MAX_LABEL = 0xFFFF;
    /** The largest label that fits into a byte. */
    public static final int MAX_BYTE_LABEL = 0xFF;

    private final int columns;
    private final int rows;
    private final int slices;
    private final byte[] bytes;
    private final short[] shorts;
    private final double[] toMm;

    private LabelGrid(int columns, int rows, int slices, byte[] bytes, short[] shorts, double[] toMm) {
        long voxels = (long) columns * rows * slices;
        int given = Math.max(bytes.length, shorts.length);
        if (columns < 1 || rows < 1 || slices < 1 || voxels != given) {
            throw new IllegalArgumentException(
                    columns + " x " + rows + " x " + slices + " voxels and " + given + " labels, expected as many");
        }
        if (toMm.length != 12) {
            throw new IllegalArgumentException("affine of " + toMm.length + " numbers, expected 12");
        }
        this.columns = columns;
        this.rows = rows;
        this.slices = slices;
        this.bytes = bytes;
        this.shorts = shorts;
        this.toMm = toMm.clone();
    }

    /**
     * A grid of labels up to 255.
     *
     * @param toMm affine matrix m0 to m11, three rows of four numbers, as above
     * @throws IllegalArgumentException if sizes do not match
     */
    public static LabelGrid of(int columns, int rows, int slices, byte[] labels, double[] toMm) {
        return new LabelGrid(columns, rows, slices, labels, new short[0], toMm);
    }

    /** A grid of labels up to 65535; the shorts are unsigned. */
    public static LabelGrid of(int columns, int rows, int slices, short[] labels, double[] toMm) {
        return new LabelGrid(columns, rows, slices, new byte[0], labels, toMm);
    }

    /** The same voxels with another affine matrix. */
    public LabelGrid withAffine(double[] otherToMm) {
        return new LabelGrid(columns, rows, slices, bytes, shorts, otherToMm);
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

    public int voxelCount() {
        return Math.max(bytes.length, shorts.length);
    }

    /** Label of a voxel by its index. */
    public int label(int voxel) {
        return bytes.length > 0 ? bytes[voxel] & MAX_BYTE_LABEL : shorts[voxel] & MAX_LABEL;
    }

    /** Label of voxel (i, j, k); 0 outside the box. */
    public int label(int i, int j, int k) {
        boolean inside = i >= 0 && i < columns && j >= 0 && j < rows && k >= 0 && k < slices;
        return inside ? label(i + columns * (j + rows * k)) : 0;
    }

    /** The affine matrix m0 to m11 from voxel indices to mm, three rows of four numbers. */
    public double[] toMm() {
        return toMm.clone();
    }

    /** Affine matrix of the part of this grid that begins at a voxel. */
    public double[] toMm(int i, int j, int k) {
        double[] origin = new double[3];
        voxelToMm(i, j, k, origin);
        double[] part = new double[12];
        double[] along = new double[3];
        for (int direction = 0; direction < 3; direction++) {
            voxelToMm(i + (direction == 0 ? 1 : 0), j + (direction == 1 ? 1 : 0), k + (direction == 2 ? 1 : 0), along);
            for (int row = 0; row < 3; row++) {
                part[4 * row + direction] = along[row] - origin[row];
                part[4 * row + 3] = origin[row];
            }
        }
        return part;
    }

    /** Converts voxel coordinates to a position in mm, written to {@code out}. */
    public void voxelToMm(double i, double j, double k, double[] out) {
        VoxelBox.apply(toMm, i, j, k, out);
    }

    /** Spacing of voxel centres along a grid direction (0 columns, 1 rows, 2 slices), mm. */
    public double spacing(int direction) {
        return VoxelBox.spacing(toMm, direction);
    }

    /** Volume of a voxel, mm^3. */
    public double voxelVolume() {
        return Math.abs(VoxelBox.determinant(toMm));
    }

    /** Volume of so many voxels, ml. */
    public double volumeMl(int voxels) {
        return voxels * voxelVolume() / MeshMeasure.MM3_PER_ML;
    }

    /**
     * Whether columns, rows and slices are left-handed, as in many NIfTI images, whose first row is at the back of the
     * body.
     */
    public boolean isMirrored() {
        return VoxelBox.determinant(toMm) < 0;
    }

    /** Number of voxels of each label, indexed by label up to the largest label present. */
    public int[] counts() {
        int[] counts = new int[(bytes.length > 0 ? MAX_BYTE_LABEL : MAX_LABEL) + 1];
        for (byte label : bytes) {
            counts[label & MAX_BYTE_LABEL]++;
        }
        for (short label : shorts) {
            counts[label & MAX_LABEL]++;
        }
        int length = counts.length;
        while (length > 1 && counts[length - 1] == 0) {
            length--;
        }
        return Arrays.copyOf(counts, length);
    }

    /**
     * Bounding box of the voxels whose label fulfils a condition: first column, row and slice, then last column, row
     * and slice. Without such voxels the last ones are -1.
     */
    public int[] box(IntPredicate wanted) {
        int[] box = {columns, rows, slices, -1, -1, -1};
        for (int k = 0; k < slices; k++) {
            for (int j = 0; j < rows; j++) {
                int row = columns * (j + rows * k);
                int first = 0;
                while (first < columns && !wanted.test(label(row + first))) {
                    first++;
                }
                if (first < columns) {
                    int last = columns - 1;
                    while (!wanted.test(label(row + last))) {
                        last--;
                    }
                    box[0] = Math.min(box[0], first);
                    box[1] = Math.min(box[1], j);
                    box[2] = Math.min(box[2], k);
                    box[3] = Math.max(box[3], last);
                    box[4] = Math.max(box[4], j);
                    box[5] = k;
                }
            }
        }
        return box;
    }

    @Override
    public String toString() {
        return "LabelGrid[" + columns + " x " + rows + " x " + slices + "]";
    }
}
