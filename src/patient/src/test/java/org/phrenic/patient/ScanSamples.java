package org.phrenic.patient;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.function.IntUnaryOperator;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

/** Scans made for tests, in LPS: two ellipsoid lungs that touch in the middle, and a liver. */
public final class ScanSamples {
    public static final int COLUMNS = 60;
    public static final int ROWS = 40;
    public static final int SLICES = 50;
    public static final double SPACING_MM = 4;
    public static final int LUNGS = 1;
    public static final int LIVER = 5;

    private ScanSamples() {}

    /** Label of each voxel, by number. */
    public static byte[] voxels() {
        byte[] labels = new byte[COLUMNS * ROWS * SLICES];
        for (int v = 0; v < labels.length; v++) {
            int i = v % COLUMNS;
            int j = v / COLUMNS % ROWS;
            int k = v / COLUMNS / ROWS;
            boolean right = within(i, j, k, 16, 20, 28, 15, 13, 18);
            boolean left = within(i, j, k, 43, 20, 28, 13, 13, 18);
            boolean liver = within(i, j, k, 20, 18, 9, 16, 13, 7);
            labels[v] = (byte) (right || left ? LUNGS : liver ? LIVER : 0);
        }
        return labels;
    }

    /** Writes them as a MetaImage. */
    public static void writeMha(Path file) throws IOException {
        String header = "ObjectType = Image\nNDims = 3\nDimSize = " + COLUMNS + " " + ROWS + " " + SLICES
                + "\nElementSpacing = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
        Files.write(file, header.getBytes(StandardCharsets.US_ASCII));
        Files.write(file, voxels(), StandardOpenOption.APPEND);
    }

    private static boolean within(int i, int j, int k, int ci, int cj, int ck, double a, double b, double c) {
        double x = (i - ci) / a;
        double y = (j - cj) / b;
        double z = (k - ck) / c;
        return x * x + y * y + z * z < 1;
    }

    static LabelVolume volume(IntUnaryOperator change, Map<Integer, String> names) {
        byte[] labels = voxels();
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) change.applyAsInt(labels[v]);
        }
        double s = SPACING_MM;
        LabelGrid grid =
                LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {s, 0, 0, -120, 0, s, 0, -80, 0, 0, s, 0});
        return new LabelVolume(grid, names, List.of());
    }

    public static LabelVolume volume() {
        return volume(label -> label, Map.of());
    }
}
