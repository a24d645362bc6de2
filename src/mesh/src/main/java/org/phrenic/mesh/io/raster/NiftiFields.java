package org.phrenic.mesh.io.raster;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.phrenic.file.BadInputException;

/**
 * The header of a NIfTI file of version 1 (348 bytes, single precision) or 2 (540 bytes, double precision), in either
 * byte order; nifti.nimh.nih.gov/nifti-2.
 */
final class NiftiFields {
    private static final int FIRST = 348;
    private static final int SECOND = 540;

    private final String file;
    private final ByteBuffer bytes;
    private final boolean isSecond;

    private NiftiFields(String file, ByteBuffer bytes, boolean isSecond) {
        this.file = file;
        this.bytes = bytes;
        this.isSecond = isSecond;
    }

    /** Reads a header up to its last byte. */
    static NiftiFields read(String file, InputStream in) throws IOException {
        byte[] content = in.readNBytes(FIRST);
        ByteBuffer bytes = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
        int little = content.length >= 4 ? bytes.getInt(0) : 0;
        int big = Integer.reverseBytes(little);
        boolean second = little == SECOND || big == SECOND;
        if (second) {
            int length = content.length;
            content = Arrays.copyOf(content, SECOND);
            length += in.readNBytes(content, length, SECOND - length);
            bytes = ByteBuffer.wrap(Arrays.copyOf(content, length));
        }
        boolean known = second || little == FIRST || big == FIRST;
        if (!known || bytes.capacity() < (second ? SECOND : FIRST)) {
            throw BadInputException.at(file, "byte 0", "found no header of 348 or 540 bytes, expected a NIfTI file");
        }
        boolean isLittle = little == (second ? SECOND : FIRST);
        bytes.order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        NiftiFields header = new NiftiFields(file, bytes, second);
        header.checkMagic();
        return header;
    }

    private void checkMagic() {
        int at = isSecond ? 4 : 344;
        byte[] letters = new byte[3];
        bytes.get(at, letters);
        String magic = new String(letters, StandardCharsets.ISO_8859_1);
        String one = isSecond ? "n+2" : "n+1";
        if (magic.equals(isSecond ? "ni2" : "ni1")) {
            throw badInput(at, "found the header of a pair .hdr and .img, expected one .nii file");
        }
        if (!magic.equals(one)) {
            throw badInput(at, "found no '" + one + "', expected a NIfTI file");
        }
    }

    /** Bytes of the header. */
    int size() {
        return isSecond ? SECOND : FIRST;
    }

    ByteOrder order() {
        return bytes.order();
    }

    /** Number of dimensions (0) or size along dimension {@code d}; sizes beyond 2^31 - 1 are refused. */
    int dimension(int d) {
        if (!isSecond) {
            return bytes.getShort(40 + 2 * d);
        }
        long size = bytes.getLong(16 + 8 * d);
        if (size != (int) size) {
            throw badInput(16 + 8 * d, "found a size of " + size + ", expected less than 2^31");
        }
        return (int) size;
    }

    int datatype() {
        return bytes.getShort(isSecond ? 12 : 70);
    }

    double pixel(int i) {
        return real(76, 104, i);
    }

    double slope() {
        return real(112, 176, 0);
    }

    double intercept() {
        return real(116, 184, 0);
    }

    /** First byte of the voxels. */
    long voxels() {
        return isSecond ? bytes.getLong(168) : Math.round(bytes.getFloat(108));
    }

    int qformCode() {
        return isSecond ? bytes.getInt(344) : bytes.getShort(252);
    }

    int sformCode() {
        return isSecond ? bytes.getInt(348) : bytes.getShort(254);
    }

    /** b, c, d of the quaternion. */
    double quaternion(int i) {
        return real(256, 352, i);
    }

    double origin(int row) {
        return real(268, 376, row);
    }

    /** Row and column of the sform. */
    double affine(int row, int column) {
        return real(280, 400, 4 * row + column);
    }

    int units() {
        return isSecond ? bytes.getInt(500) : bytes.get(123);
    }

    private double real(int first, int second, int i) {
        return isSecond ? bytes.getDouble(second + 8 * i) : bytes.getFloat(first + 4 * i);
    }

    BadInputException badInput(int at, String problem) {
        return BadInputException.at(file, "byte " + at, problem);
    }

    /** An exception about the datatype. */
    BadInputException badDatatype(String problem) {
        return badInput(isSecond ? 12 : 70, problem);
    }

    /** An exception about the dimensions. */
    BadInputException badDimensions(String problem) {
        return badInput(isSecond ? 16 : 40, problem);
    }

    /** An exception about the place of the voxels. */
    BadInputException badVoxels(String problem) {
        return badInput(isSecond ? 168 : 108, problem);
    }
}
