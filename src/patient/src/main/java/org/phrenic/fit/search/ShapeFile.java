package org.phrenic.fit.search;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.file.OutputException;

/**
 * Shapes of the breaths that a fit learns from, beside its journal: for each the number of the evaluation, how many
 * numbers follow, and these (big-endian, 4 bytes each), all under the fit's mark. What a kill cut off, or is of another
 * fit, is not there.
 */
final class ShapeFile implements AutoCloseable {
    private final Path file;
    private final byte[] mark;
    private final Map<Integer, Long> places = new TreeMap<>();
    private long end;
    private DataOutputStream writer;

    ShapeFile(Path file, String mark) {
        this.file = file;
        this.mark = mark.getBytes(java.nio.charset.StandardCharsets.US_ASCII);
        if (Files.exists(file)) {
            find();
        }
    }

    private void find() {
        try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
            if (!java.util.Arrays.equals(in.readNBytes(mark.length), mark)) {
                return;
            }
            long size = Files.size(file);
            end = mark.length;
            while (end + 2L * Integer.BYTES <= size) {
                int number = in.readInt();
                long next = end + 2L * Integer.BYTES + (long) Float.BYTES * in.readInt();
                if (next < end || next > size) {
                    return;
                }
                in.skipNBytes(next - end - 2L * Integer.BYTES);
                places.put(number, end + Integer.BYTES);
                end = next;
            }
        } catch (EOFException cut) {
            // what was found counts
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The shape of an evaluation; null if it is not there. */
    synchronized float[] shape(int number) {
        Long place = places.get(number);
        if (place == null) {
            return null;
        }
        try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
            in.seek(place);
            byte[] bytes = new byte[Float.BYTES * in.readInt()];
            in.readFully(bytes);
            float[] shape = new float[bytes.length / Float.BYTES];
            ByteBuffer.wrap(bytes).asFloatBuffer().get(shape);
            return shape;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Writes a shape through, if it is not there. */
    synchronized void add(int number, float[] shape) {
        if (places.containsKey(number)) {
            return;
        }
        try {
            if (writer == null) {
                open();
            }
            ByteBuffer bytes = ByteBuffer.allocate(2 * Integer.BYTES + Float.BYTES * shape.length);
            bytes.putInt(number).putInt(shape.length).asFloatBuffer().put(shape);
            writer.write(bytes.array());
            writer.flush();
            places.put(number, end + Integer.BYTES);
            end += bytes.capacity();
        } catch (IOException e) {
            throw new OutputException(file + ": found no way to write, expected room for the shapes", e);
        }
    }

    /** Behind what is whole. */
    private void open() throws IOException {
        if (end == 0) {
            Files.createDirectories(file.toAbsolutePath().getParent());
            Files.write(file, mark);
            end = mark.length;
        } else {
            try (RandomAccessFile whole = new RandomAccessFile(file.toFile(), "rw")) {
                whole.setLength(end);
            }
        }
        writer = new DataOutputStream(Files.newOutputStream(file, StandardOpenOption.APPEND));
    }

    @Override
    public synchronized void close() {
        if (writer != null) {
            try {
                writer.close();
            } catch (IOException e) {
                throw new OutputException(file + ": found no way to write, expected room for the shapes", e);
            }
        }
    }
}
