package org.phrenic.fit.search;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.file.OutputException;

/**
 * File of shapes stored next to a journal. It contains the mark of the fit, followed by one entry per shape: number of
 * the evaluation, length and coordinates (big-endian, 4 bytes each). An incomplete last entry is ignored and
 * overwritten, as is a file of another fit.
 */
final class ShapeFile {
    private static final int HEADER_BYTES = 2 * Integer.BYTES;

    private final Path file;
    private final byte[] mark;
    private final Map<Integer, Long> offsets = new TreeMap<>();
    private long end;

    ShapeFile(Path file, String mark) {
        this.file = file;
        this.mark = mark.getBytes(StandardCharsets.US_ASCII);
        if (Files.exists(file)) {
            index();
        }
    }

    private void index() {
        try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
            byte[] start = new byte[mark.length];
            if (in.read(start) < start.length || !Arrays.equals(start, mark)) {
                return;
            }
            end = start.length;
            while (end + HEADER_BYTES <= in.length()) {
                in.seek(end);
                int number = in.readInt();
                int length = in.readInt();
                long next = end + HEADER_BYTES + (long) Float.BYTES * length;
                if (length < 0 || next > in.length()) {
                    return;
                }
                offsets.put(number, end + Integer.BYTES);
                end = next;
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Shape of an evaluation, or null if there is none. */
    synchronized float[] shape(int number) {
        Long offset = offsets.get(number);
        if (offset == null) {
            return null;
        }
        try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
            in.seek(offset);
            byte[] bytes = new byte[Float.BYTES * in.readInt()];
            in.readFully(bytes);
            float[] shape = new float[bytes.length / Float.BYTES];
            ByteBuffer.wrap(bytes).asFloatBuffer().get(shape);
            return shape;
        } catch (IOException e) {
            throw new UncheckedIOException(file + ": reading failed", e);
        }
    }

    /** Writes a shape, in the place of one with the same number and length. */
    synchronized void add(int number, float[] shape) {
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            try (RandomAccessFile out = new RandomAccessFile(file.toFile(), "rw")) {
                if (end == 0) {
                    out.write(mark);
                    end = mark.length;
                }
                ByteBuffer bytes = ByteBuffer.allocate(HEADER_BYTES + Float.BYTES * shape.length);
                bytes.putInt(number).putInt(shape.length).asFloatBuffer().put(shape);
                long at = isStored(out, number, shape.length) ? offsets.get(number) - Integer.BYTES : end;
                out.seek(at);
                out.write(bytes.array());
                offsets.put(number, at + Integer.BYTES);
                end = Math.max(end, out.getFilePointer());
                out.setLength(end);
            }
        } catch (IOException e) {
            throw new OutputException(file + ": found no way to write, expected room for the shapes", e);
        }
    }

    private boolean isStored(RandomAccessFile in, int number, int length) throws IOException {
        Long offset = offsets.get(number);
        if (offset == null) {
            return false;
        }
        in.seek(offset);
        return in.readInt() == length;
    }
}
