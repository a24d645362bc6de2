package org.phrenic.mesh.io.raster;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.OptionalDouble;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;

/** Numbers in text, separated by white space or commas, as big-endian bytes of double precision. */
final class TextVoxels extends InputStream {
    /** Longest text of a number. */
    private static final int MAX_LENGTH = 64;

    private final String file;
    private final InputStream in;
    private final byte[] word = new byte[MAX_LENGTH];
    private final ByteBuffer value = ByteBuffer.allocate(Double.BYTES);
    private long read;

    TextVoxels(String file, InputStream in) {
        this.file = file;
        this.in = in;
        value.position(Double.BYTES);
    }

    /** The decoder of these bytes. */
    static VoxelDecoder decoder(int[] sizes) {
        return new VoxelDecoder(sizes, ScalarType.FLOAT64, ByteOrder.BIG_ENDIAN);
    }

    /** Rejects sizes that a text of {@code available} bytes cannot hold. */
    static void validate(String file, VoxelDecoder voxels, long available, int volumes) {
        new VoxelDecoder(voxels.sizes(), ScalarType.UINT8, ByteOrder.BIG_ENDIAN)
                .validate(file, available, false, volumes);
    }

    @Override
    public int read() throws IOException {
        return isFilled() ? value.get() & 0xFF : -1;
    }

    @Override
    public int read(byte[] to, int offset, int length) throws IOException {
        int done = 0;
        while (done < length && isFilled()) {
            int now = Math.min(length - done, value.remaining());
            value.get(to, offset + done, now);
            done += now;
        }
        return done == 0 && length > 0 ? -1 : done;
    }

    private boolean isFilled() throws IOException {
        if (value.hasRemaining()) {
            return true;
        }
        int c = in.read();
        while (isSeparator(c)) {
            c = in.read();
        }
        if (c < 0) {
            return false;
        }
        int length = 0;
        while (c >= 0 && !isSeparator(c) && length < MAX_LENGTH) {
            word[length++] = (byte) c;
            c = in.read();
        }
        String text = new String(word, 0, length, StandardCharsets.ISO_8859_1);
        boolean isWhole = c < 0 || isSeparator(c);
        double number = (isWhole ? Numbers.parse(text) : OptionalDouble.empty())
                .orElseThrow(() -> BadInputException.at(
                        file,
                        "value " + read,
                        "found " + Numbers.quote(text) + ", expected a number, as voxels are text by the header"));
        read++;
        value.clear();
        value.putDouble(number).flip();
        return true;
    }

    private static boolean isSeparator(int c) {
        return c == ' ' || c == ',' || (c >= '\t' && c <= '\r');
    }
}
