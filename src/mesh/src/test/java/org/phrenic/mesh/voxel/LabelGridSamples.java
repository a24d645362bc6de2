package org.phrenic.mesh.voxel;

/** Volumes of labels made for tests. */
public final class LabelGridSamples {
    private LabelGridSamples() {}

    /**
     * Label 1 where the centre of a voxel lies within an ellipsoid about the middle of the box, semi-axes in voxels.
     */
    public static LabelGrid ellipsoid(
            int columns, int rows, int slices, double[] affine, double a, double b, double c) {
        byte[] labels = new byte[columns * rows * slices];
        for (int v = 0; v < labels.length; v++) {
            double x = (v % columns - (columns - 1) / 2.0) / a;
            double y = (v / columns % rows - (rows - 1) / 2.0) / b;
            double z = (v / columns / rows - (slices - 1) / 2.0) / c;
            labels[v] = (byte) (x * x + y * y + z * z < 1 ? 1 : 0);
        }
        return LabelGrid.of(columns, rows, slices, labels, affine);
    }
}
