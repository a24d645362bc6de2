package org.phrenic.mesh.io.volume;

import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;
import org.phrenic.file.AtomicFile;
import org.phrenic.mesh.voxel.LabelGrid;

/** Writer of label volumes as NIfTI-1, gzip, unsigned bytes or 16-bit numbers, little-endian, with an sform. */
public final class NiftiWriter {
    private static final int HEADER = 348;
    private static final int DATA = 352;
    private static final short UINT8 = 2;
    private static final short UINT16 = 512;
    private static final byte MM = 2;

    private NiftiWriter() {}

    /**
     * Writes a volume to {@code .nii.gz}; the file is written completely or not at all.
     *
     * @throws org.phrenic.file.OutputException if the file cannot be written
     */
    public static void write(Path file, LabelGrid grid) {
        boolean small = grid.counts().length <= LabelGrid.MAX_BYTE_LABEL + 1;
        byte[] header = header(grid, small);
        AtomicFile.write(file, out -> {
            try (OutputStream packed = new GZIPOutputStream(out, 1 << 16)) {
                packed.write(header);
                int slice = grid.columns() * grid.rows();
                byte[] bytes = new byte[small ? slice : 2 * slice];
                for (int k = 0; k < grid.slices(); k++) {
                    for (int i = 0; i < slice; i++) {
                        int label = grid.label(k * slice + i);
                        if (small) {
                            bytes[i] = (byte) label;
                        } else {
                            bytes[2 * i] = (byte) label;
                            bytes[2 * i + 1] = (byte) (label >> Byte.SIZE);
                        }
                    }
                    packed.write(bytes);
                }
            }
        });
    }

    private static byte[] header(LabelGrid grid, boolean small) {
        ByteBuffer h = ByteBuffer.allocate(DATA).order(ByteOrder.LITTLE_ENDIAN);
        h.putInt(0, HEADER);
        int[] sizes = {3, grid.columns(), grid.rows(), grid.slices(), 1, 1, 1, 1};
        for (int i = 0; i < sizes.length; i++) {
            h.putShort(40 + 2 * i, (short) sizes[i]);
        }
        h.putShort(70, small ? UINT8 : UINT16);
        h.putShort(72, (short) (small ? Byte.SIZE : Short.SIZE));
        h.putFloat(76, 1);
        for (int axis = 0; axis < 3; axis++) {
            h.putFloat(80 + 4 * axis, (float) grid.spacing(axis));
        }
        h.putFloat(108, DATA);
        h.put(123, MM);
        h.putShort(254, (short) 1);
        putAffine(grid, h);
        h.position(344);
        h.put("n+1\0".getBytes(StandardCharsets.ISO_8859_1));
        h.rewind();
        return h.array();
    }

    /** The sform, whose axes are RAS: x and y of LPS change sign. */
    private static void putAffine(LabelGrid grid, ByteBuffer h) {
        double[] origin = new double[3];
        double[] step = new double[3];
        grid.voxelToMm(0, 0, 0, origin);
        for (int column = 0; column < 4; column++) {
            if (column < 3) {
                grid.voxelToMm(column == 0 ? 1 : 0, column == 1 ? 1 : 0, column == 2 ? 1 : 0, step);
            }
            for (int row = 0; row < 3; row++) {
                double value = column == 3 ? origin[row] : step[row] - origin[row];
                h.putFloat(280 + 16 * row + 4 * column, (float) (row < 2 ? -value : value));
            }
        }
    }
}
