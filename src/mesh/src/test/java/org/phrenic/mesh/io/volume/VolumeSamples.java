package org.phrenic.mesh.io.volume;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.GZIPOutputStream;
import org.apache.commons.compress.compressors.bzip2.BZip2CompressorOutputStream;

/** Volumes of 4 x 3 x 2 voxels as bytes of files: voxel (i, j, k) has the label i + 4 j + 12 k. */
public final class VolumeSamples {
    public static final int COLUMNS = 4;
    public static final int ROWS = 3;
    public static final int SLICES = 2;
    public static final int VOXELS = COLUMNS * ROWS * SLICES;
    public static final int NIFTI_HEADER = 352;

    private VolumeSamples() {}

    /** Voxels of a NIfTI datatype code; values are the labels, times a factor. */
    public static byte[] voxels(int datatype, ByteOrder order, double factor) {
        int size =
                switch (datatype) {
                    case 2, 256 -> 1;
                    case 4, 512 -> 2;
                    case 8, 768, 16 -> 4;
                    default -> 8;
                };
        ByteBuffer data = ByteBuffer.allocate(VOXELS * size).order(order);
        for (int v = 0; v < VOXELS; v++) {
            double value = factor * v;
            switch (datatype) {
                case 2, 256 -> data.put((byte) value);
                case 4, 512 -> data.putShort((short) value);
                case 8, 768 -> data.putInt((int) value);
                case 16 -> data.putFloat((float) value);
                case 64 -> data.putDouble(value);
                default -> data.putLong((long) value);
            }
        }
        return data.array();
    }

    /**
     * NIfTI-1: columns run to the left by 2 mm, rows to the front by 3 mm, slices up by 4 mm, the first voxel at x =
     * 10, y = 20, z = 30 mm of RAS, by the sform.
     *
     * @param change made to the header before it is joined with the voxels
     */
    public static byte[] nifti(int datatype, ByteOrder order, Consumer<ByteBuffer> change) {
        ByteBuffer h = ByteBuffer.allocate(NIFTI_HEADER).order(order);
        h.putInt(0, 348);
        short[] dim = {3, COLUMNS, ROWS, SLICES, 1, 1, 1, 1};
        for (int i = 0; i < 8; i++) {
            h.putShort(40 + 2 * i, dim[i]);
        }
        h.putShort(70, (short) datatype);
        float[] pixdim = {1, 2, 3, 4};
        for (int i = 0; i < 4; i++) {
            h.putFloat(76 + 4 * i, pixdim[i]);
        }
        h.putFloat(108, NIFTI_HEADER);
        h.put(123, (byte) 2);
        h.putShort(254, (short) 1);
        float[] rows = {-2, 0, 0, 10, 0, 3, 0, 20, 0, 0, 4, 30};
        for (int i = 0; i < 12; i++) {
            h.putFloat(280 + 4 * i, rows[i]);
        }
        h.put(344, new byte[] {'n', '+', '1', 0});
        change.accept(h);
        return join(h.array(), voxels(datatype, order, 1));
    }

    public static byte[] nifti() {
        return nifti(2, ByteOrder.LITTLE_ENDIAN, h -> {});
    }

    /** A NRRD header without the empty line at its end; the place of {@link #nifti} in RAS. */
    public static String nrrd(String type, String encoding) {
        return "NRRD0004\n# made by hand\ntype: " + type
                + "\ndimension: 3\nspace: right-anterior-superior\nsizes: 4 3 2\n"
                + "space directions: (-2,0,0) (0,3,0) (0,0,4)\nkinds: domain domain domain\nendian: little\nencoding: "
                + encoding + "\nspace origin: (10,20,30)\n";
    }

    /** A MetaImage header up to the data file; the place of {@link #nifti} in LPS. */
    public static String meta(String type, boolean packed) {
        return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = "
                + (packed ? "True" : "False")
                + "\nTransformMatrix = 1 0 0 0 -1 0 0 0 1\nOffset = -10 -20 30\nElementSpacing = 2 3 4"
                + "\nDimSize = 4 3 2\nElementType = "
                + type + "\nElementDataFile = ";
    }

    public static byte[] gzip(byte[] content) {
        return packed(content, true);
    }

    public static byte[] zlib(byte[] content) {
        return packed(content, false);
    }

    static byte[] bzip2(byte[] content) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (OutputStream out = new BZip2CompressorOutputStream(bytes)) {
            out.write(content);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return bytes.toByteArray();
    }

    private static byte[] packed(byte[] content, boolean gzip) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (OutputStream out = gzip ? new GZIPOutputStream(bytes) : new DeflaterOutputStream(bytes)) {
            out.write(content);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return bytes.toByteArray();
    }

    public static byte[] join(byte[] first, byte[] second) {
        return ByteBuffer.allocate(first.length + second.length)
                .put(first)
                .put(second)
                .array();
    }

    public static byte[] join(String header, byte[] data) {
        return join(header.getBytes(StandardCharsets.UTF_8), data);
    }

    /** A file of the folder of volumes that other programs wrote. */
    public static Path resource(String name) {
        try {
            return Path.of(VolumeSamples.class.getResource(name).toURI());
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    public static Path write(Path folder, String name, byte[] content) {
        try {
            return Files.write(folder.resolve(name), content);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
