package org.phrenic.mesh.voxel;

import java.util.Arrays;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.TriangleMesh;

/**
 * Writes the inside of closed surfaces into the voxels of a box. A voxel is inside if the line through its centre along
 * the columns enters the surface an odd number of times before it. Lines run beside voxel centres by a ten-thousandth
 * of a voxel, so that none meets a corner of a mesh whose coordinates are round numbers.
 */
public final class MeshVoxelizer {
    private static final double BESIDE_J = 1.3e-4;
    private static final double BESIDE_K = 0.7e-4;

    private final int columns;
    private final int rows;
    private final int slices;
    private final double[] toVoxel;
    private final byte[] labels;

    /**
     * @param toVoxel affine matrix from mm to voxel indices, three rows of four numbers
     * @param labels one byte a voxel, index {@code i + columns (j + rows k)}; receives the labels
     */
    public MeshVoxelizer(int columns, int rows, int slices, double[] toVoxel, byte[] labels) {
        if ((long) columns * rows * slices != labels.length || toVoxel.length != 12) {
            throw new IllegalArgumentException(columns + " x " + rows + " x " + slices + " voxels and " + labels.length
                    + " labels, affine of " + toVoxel.length + " numbers, expected as many labels and 12 numbers");
        }
        this.columns = columns;
        this.rows = rows;
        this.slices = slices;
        this.toVoxel = toVoxel.clone();
        this.labels = labels;
    }

    /**
     * Gives all voxels inside a surface a label; returns their number.
     *
     * @param label 0 to 255
     * @throws IllegalArgumentException if the label does not fit in a byte
     */
    public int fill(TriangleMesh mesh, int label) {
        if (label < 0 || label > LabelGrid.MAX_BYTE_LABEL) {
            throw new IllegalArgumentException("label: found " + label + ", expected 0 to " + LabelGrid.MAX_BYTE_LABEL);
        }
        double[] p = indices(mesh.positions());
        DoubleList[] crossings = new DoubleList[rows * slices];
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i += 3) {
            cross(p, 3 * t[i], 3 * t[i + 1], 3 * t[i + 2], crossings);
        }
        int filled = 0;
        for (int line = 0; line < crossings.length; line++) {
            filled += crossings[line] == null ? 0 : fill(crossings[line].toArray(), line * columns, (byte) label);
        }
        return filled;
    }

    private double[] indices(double[] points) {
        double[] p = new double[points.length];
        for (int k = 0; k < p.length; k += 3) {
            for (int axis = 0; axis < 3; axis++) {
                int m = 4 * axis;
                p[k + axis] = toVoxel[m] * points[k]
                        + toVoxel[m + 1] * points[k + 1]
                        + toVoxel[m + 2] * points[k + 2]
                        + toVoxel[m + 3];
            }
        }
        return p;
    }

    /** Adds the crossings of a triangle with the lines that it covers. */
    private void cross(double[] p, int a, int b, int c, DoubleList[] crossings) {
        double doubled = area(p, a, b, p[c + 1], p[c + 2]);
        if (doubled == 0) {
            return;
        }
        int firstRow = first(Math.min(p[a + 1], Math.min(p[b + 1], p[c + 1])));
        int lastRow = Math.min(rows - 1, (int) Math.floor(Math.max(p[a + 1], Math.max(p[b + 1], p[c + 1]))));
        int firstSlice = first(Math.min(p[a + 2], Math.min(p[b + 2], p[c + 2])));
        int lastSlice = Math.min(slices - 1, (int) Math.floor(Math.max(p[a + 2], Math.max(p[b + 2], p[c + 2]))));
        for (int k = firstSlice; k <= lastSlice; k++) {
            for (int j = firstRow; j <= lastRow; j++) {
                double y = j + BESIDE_J;
                double z = k + BESIDE_K;
                double wa = area(p, b, c, y, z) / doubled;
                double wb = area(p, c, a, y, z) / doubled;
                double wc = area(p, a, b, y, z) / doubled;
                if (wa >= 0 && wb >= 0 && wc >= 0) {
                    int line = j + rows * k;
                    crossings[line] = crossings[line] == null ? new DoubleList() : crossings[line];
                    crossings[line].add(wa * p[a] + wb * p[b] + wc * p[c]);
                }
            }
        }
    }

    private static int first(double least) {
        return Math.max(0, (int) Math.floor(least));
    }

    /** Twice the area of the triangle of two corners and a point in the plane of rows and slices. */
    private static double area(double[] p, int a, int b, double y, double z) {
        return (p[b + 1] - p[a + 1]) * (z - p[a + 2]) - (p[b + 2] - p[a + 2]) * (y - p[a + 1]);
    }

    /** Fills one line between its first and second crossing, third and fourth, and so on. */
    private int fill(double[] crossings, int offset, byte label) {
        Arrays.sort(crossings);
        int filled = 0;
        for (int i = 0; i + 1 < crossings.length; i += 2) {
            int from = Math.max(0, (int) Math.ceil(crossings[i]));
            int to = Math.min(columns - 1, (int) Math.floor(crossings[i + 1]));
            for (int v = from; v <= to; v++) {
                labels[offset + v] = label;
                filled++;
            }
        }
        return filled;
    }
}
