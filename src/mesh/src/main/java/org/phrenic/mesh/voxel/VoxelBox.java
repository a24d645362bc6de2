package org.phrenic.mesh.voxel;

import java.util.Arrays;

/**
 * Size and place of a box of voxels. Voxel (i, j, k) has the index {@code i + columns (j + rows k)}, and its centre is
 * at
 *
 * <pre>
 * x = m0 i + m1 j + m2 k + m3,   y = m4 i + m5 j + m6 k + m7,   z = m8 i + m9 j + m10 k + m11   (mm)
 * </pre>
 *
 * @param size columns, rows, slices
 * @param toMm affine matrix m0 to m11, three rows of four numbers, LPS
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record VoxelBox(int[] size, double[] toMm) {
    /** @throws IllegalArgumentException if a size is less than 1 or the matrix is not invertible */
    public VoxelBox {
        if (size.length != 3 || toMm.length != 12 || Arrays.stream(size).anyMatch(n -> n < 1)) {
            throw new IllegalArgumentException(Arrays.toString(size) + " voxels, expected three sizes from 1 on");
        }
        size = size.clone();
        toMm = toMm.clone();
        double det = determinant(toMm);
        if (!(Math.abs(det) > 0) || !Double.isFinite(det)) {
            throw new IllegalArgumentException("found voxels whose axes lie in a plane, expected three directions");
        }
    }

    /** A box with cubes as voxels, parallel to the axes of the body, that covers two corners. */
    public static VoxelBox covering(double[] low, double[] high, double edge) {
        int[] size = new int[3];
        double[] first = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            first[axis] = edge * Math.floor(low[axis] / edge);
            size[axis] = 1 + (int) Math.ceil((high[axis] - first[axis]) / edge);
        }
        double[] toMm = {edge, 0, 0, first[0], 0, edge, 0, first[1], 0, 0, edge, first[2]};
        return new VoxelBox(size, toMm);
    }

    /** The box of a label volume. */
    public static VoxelBox of(LabelGrid grid) {
        return new VoxelBox(new int[] {grid.columns(), grid.rows(), grid.slices()}, grid.toMm());
    }

    /** The box of an image. */
    public static VoxelBox of(ImageGrid grid) {
        return new VoxelBox(new int[] {grid.columns(), grid.rows(), grid.slices()}, grid.toMm());
    }

    public int columns() {
        return size[0];
    }

    public int rows() {
        return size[1];
    }

    public int slices() {
        return size[2];
    }

    /** Number of voxels. */
    public int voxels() {
        return Math.multiplyExact(Math.multiplyExact(size[0], size[1]), size[2]);
    }

    /** Converts voxel coordinates to a position in mm, written to {@code out}. */
    public void voxelToMm(double i, double j, double k, double[] out) {
        apply(toMm, i, j, k, out);
    }

    /** Applies an affine matrix of three rows of four numbers to a point. */
    public static void apply(double[] matrix, double x, double y, double z, double[] out) {
        for (int row = 0; row < 3; row++) {
            int m = 4 * row;
            out[row] = matrix[m] * x + matrix[m + 1] * y + matrix[m + 2] * z + matrix[m + 3];
        }
    }

    /** Affine matrix of the grid of another that begins at one of its voxels, or so many voxels before it. */
    public static double[] beginningAt(double[] toMm, int i, int j, int k) {
        double[] shifted = toMm.clone();
        int[] first = {i, j, k};
        for (int row = 0; row < 3; row++) {
            for (int direction = 0; direction < 3; direction++) {
                shifted[4 * row + 3] += first[direction] * toMm[4 * row + direction];
            }
        }
        return shifted;
    }

    /** Spacing of voxel centres along a grid direction (0 columns, 1 rows, 2 slices), mm. */
    public double spacing(int direction) {
        return spacing(toMm, direction);
    }

    static double spacing(double[] toMm, int direction) {
        double x = toMm[direction];
        double y = toMm[4 + direction];
        double z = toMm[8 + direction];
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** The affine matrix from mm to voxel coordinates. */
    public double[] toVoxel() {
        double[] m = toMm;
        double det = determinant(m);
        double[] out = {
            m[5] * m[10] - m[6] * m[9], m[2] * m[9] - m[1] * m[10], m[1] * m[6] - m[2] * m[5], 0,
            m[6] * m[8] - m[4] * m[10], m[0] * m[10] - m[2] * m[8], m[2] * m[4] - m[0] * m[6], 0,
            m[4] * m[9] - m[5] * m[8], m[1] * m[8] - m[0] * m[9], m[0] * m[5] - m[1] * m[4], 0
        };
        for (int row = 0; row < 12; row += 4) {
            for (int column = 0; column < 3; column++) {
                out[row + column] /= det;
            }
            out[row + 3] = -(out[row] * m[3] + out[row + 1] * m[7] + out[row + 2] * m[11]);
        }
        return out;
    }

    static double determinant(double[] m) {
        return m[0] * (m[5] * m[10] - m[6] * m[9])
                - m[1] * (m[4] * m[10] - m[6] * m[8])
                + m[2] * (m[4] * m[9] - m[5] * m[8]);
    }
}
