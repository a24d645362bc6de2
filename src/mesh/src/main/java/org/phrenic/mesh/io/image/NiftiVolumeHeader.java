package org.phrenic.mesh.io.image;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.voxel.VoxelBox;

/** The header of a NIfTI-1 file in one piece, little-endian, with an sform (Cox et al. 2004). */
public final class NiftiVolumeHeader {
    /** Intent of a volume of displacements, mm, RAS: dimensions x, y, z, 1, 3. */
    public static final short DISPLACEMENT = 1006;

    private static final int HEADER = 348;
    /** Where voxels begin. */
    private static final int DATA = 352;

    private static final int DESCRIPTION = 79;
    private static final byte MM = 2;
    private static final byte SECONDS = 8;

    private final ByteBuffer h = ByteBuffer.allocate(DATA).order(ByteOrder.LITTLE_ENDIAN);

    /** A header of one volume with one number a voxel. */
    public NiftiVolumeHeader(VoxelBox box, ScalarType type) {
        h.putInt(0, HEADER);
        dimensions(3, box.columns(), box.rows(), box.slices());
        h.putShort(70, code(type));
        h.putShort(72, (short) (Byte.SIZE * type.size()));
        h.putFloat(76, 1);
        for (int axis = 0; axis < 3; axis++) {
            h.putFloat(80 + 4 * axis, (float) box.spacing(axis));
        }
        h.putFloat(108, DATA);
        h.put(123, MM);
        h.putShort(254, (short) 1);
        // The axes of the sform are RAS: x and y of LPS change sign.
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 4; column++) {
                double value = box.toMm()[4 * row + column];
                h.putFloat(280 + 16 * row + 4 * column, (float) (row < 2 ? -value : value));
            }
        }
        h.position(344);
        h.put("n+1\0".getBytes(StandardCharsets.ISO_8859_1));
    }

    private void dimensions(int... sizes) {
        for (int i = 0; i < 8; i++) {
            h.putShort(40 + 2 * i, (short) (i < sizes.length ? sizes[i] : 1));
        }
    }

    private static short code(ScalarType type) {
        return switch (type) {
            case UINT8 -> 2;
            case INT16 -> 4;
            case FLOAT32 -> 16;
            case UINT16 -> 512;
            default -> throw new IllegalArgumentException(type + " voxels, expected UINT8, INT16, UINT16 or FLOAT32");
        };
    }

    /** One volume or several with their times. */
    NiftiVolumeHeader frames(VoxelBox box, VoxelSeries.Times times) {
        if (times.frames() > 1) {
            dimensions(4, box.columns(), box.rows(), box.slices(), times.frames());
            h.putFloat(92, (float) times.intervalS());
        }
        h.put(123, (byte) (MM | SECONDS));
        h.putFloat(136, (float) times.firstS());
        return this;
    }

    /** Three numbers a voxel, a displacement. */
    NiftiVolumeHeader displacement(VoxelBox box) {
        dimensions(5, box.columns(), box.rows(), box.slices(), 1, 3);
        h.putFloat(92, 1);
        h.putFloat(96, 1);
        h.putShort(68, DISPLACEMENT);
        h.position(328);
        h.put("displacement".getBytes(StandardCharsets.ISO_8859_1));
        return this;
    }

    /** States what the file holds; at most 79 characters are kept. */
    NiftiVolumeHeader described(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        h.position(148);
        h.put(Arrays.copyOf(bytes, Math.min(DESCRIPTION, bytes.length)));
        return this;
    }

    /** The bytes before the first voxel. */
    public byte[] bytes() {
        return h.array();
    }
}
