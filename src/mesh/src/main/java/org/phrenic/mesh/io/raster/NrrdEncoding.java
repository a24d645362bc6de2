package org.phrenic.mesh.io.raster;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.zip.GZIPInputStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;

/**
 * How the voxels of a NRRD file are stored: as they are, packed by gzip or bzip2, or as numbers in text.
 *
 * @param kind raw, gzip, bzip2 or text
 */
record NrrdEncoding(VolumeHeader header, String kind) {
    static final String LINE_SKIP = "line skip";
    static final String BYTE_SKIP = "byte skip";
    /** The value of {@link #BYTE_SKIP} by which the voxels end the unpacked data. */
    private static final int FROM_END = -1;

    /** @throws BadInputException if the header states another encoding */
    static NrrdEncoding of(VolumeHeader header) {
        String encoding = header.text("encoding").toLowerCase(Locale.ROOT);
        return switch (encoding) {
            case "raw" -> new NrrdEncoding(header, "raw");
            case "gzip", "gz" -> new NrrdEncoding(header, "gzip");
            case "bzip2", "bz2" -> new NrrdEncoding(header, "bzip2");
            case "ascii", "text", "txt" -> new NrrdEncoding(header, "text");
            default -> throw header.unexpected("encoding", encoding, "raw, gzip, bzip2 or ascii");
        };
    }

    private boolean isText() {
        return kind.equals("text");
    }

    /** The decoder of voxels of this type. */
    VoxelDecoder decoder(int[] sizes, ScalarType type) {
        return isText() ? TextVoxels.decoder(sizes) : new VoxelDecoder(sizes, type, order(type));
    }

    private ByteOrder order(ScalarType type) {
        String endian = header.text("endian", "").toLowerCase(Locale.ROOT);
        if (type.size() > 1 && !endian.equals("little") && !endian.equals("big")) {
            String found = ": found endian " + Numbers.quote(endian);
            throw new BadInputException(header.file() + found + ", expected little or big");
        }
        return endian.equals("big") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    }

    /**
     * The values of all volumes.
     *
     * @param in data of the file {@code data}, behind the header if that is in it
     * @param attached whether the header is in the file
     * @throws BadInputException if the file is too short for them
     */
    InputStream voxels(Path data, InputStream in, VoxelDecoder voxels, int volumes, boolean attached)
            throws IOException {
        String file = data.toString();
        long size = InputBytes.size(data);
        if (isText()) {
            TextVoxels.validate(file, voxels, size, volumes);
        } else {
            // By bzip2 equal voxels are packed a million to one: the size of the file says nothing.
            voxels.validate(file, kind.equals("bzip2") ? Long.MAX_VALUE : size, kind.equals("gzip"), volumes);
        }
        long before = attached ? 0 : header.bytes();
        int lines = header.has(LINE_SKIP) ? header.integers(LINE_SKIP)[0] : 0;
        if (lines < 0) {
            throw header.badInput(LINE_SKIP, "found " + lines + ", expected 0 or more");
        }
        for (int n = lines; n > 0; n--) {
            if (header.line(in) == null) {
                throw new EOFException();
            }
        }
        long skip = header.has(BYTE_SKIP) ? header.integers(BYTE_SKIP)[0] : 0;
        if (skip == FROM_END && !isText()) {
            skip = skipToEnd(data, header.bytes() - before, voxels.bytes() * volumes);
        }
        if (skip < 0) {
            throw header.badInput(BYTE_SKIP, "found " + skip + ", expected 0 or more");
        }
        InputStream unpacked = unpacked(in);
        unpacked.skipNBytes(skip);
        return isText() ? new TextVoxels(file, unpacked) : unpacked;
    }

    /**
     * Number of unpacked bytes before those that end the data; packed data are unpacked once to count them.
     *
     * @param start first byte of the data in their file
     * @param needed number of bytes at the end
     */
    private long skipToEnd(Path data, long start, long needed) throws IOException {
        long length = InputBytes.size(data) - start;
        if (!kind.equals("raw")) {
            try (InputStream in = new BufferedInputStream(Files.newInputStream(data), 1 << 16)) {
                in.skipNBytes(start);
                length = unpacked(in).transferTo(OutputStream.nullOutputStream());
            }
        }
        if (length < needed) {
            throw new BadInputException(
                    data + ": found " + length + " bytes of voxels, expected " + needed + " at the end of the data");
        }
        return length - needed;
    }

    private InputStream unpacked(InputStream in) throws IOException {
        return switch (kind) {
            case "gzip" -> new GZIPInputStream(in, 1 << 16);
            case "bzip2" -> Bzip2Voxels.of(in);
            default -> in;
        };
    }
}
