package org.phrenic.file;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Writes numbers as little-endian bytes to a buffered stream. */
public final class LittleEndianOutput {
    private final OutputStream out;
    private final byte[] bytes = new byte[8];
    private final ByteBuffer buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);

    public LittleEndianOutput(OutputStream out) {
        this.out = out;
    }

    public void text(String ascii) throws IOException {
        out.write(ascii.getBytes(StandardCharsets.UTF_8));
    }

    public void int8(int value) throws IOException {
        out.write(value);
    }

    public void int16(int value) throws IOException {
        buffer.putShort(0, (short) value);
        out.write(bytes, 0, 2);
    }

    public void int32(int value) throws IOException {
        buffer.putInt(0, value);
        out.write(bytes, 0, 4);
    }

    public void int64(long value) throws IOException {
        buffer.putLong(0, value);
        out.write(bytes, 0, 8);
    }

    public void float32(float value) throws IOException {
        buffer.putFloat(0, value);
        out.write(bytes, 0, 4);
    }

    public void float64(double value) throws IOException {
        buffer.putDouble(0, value);
        out.write(bytes, 0, 8);
    }

    public void float64(double[] values) throws IOException {
        for (double value : values) {
            float64(value);
        }
    }

    /** Rejects coordinates that are not finite, which readers reject, before an output file is created. */
    public static void requireFinite(double[] positions) {
        for (int i = 0; i < positions.length; i++) {
            if (!Double.isFinite(positions[i])) {
                throw new IllegalArgumentException(
                        "vertex " + i / 3 + ": found coordinate " + positions[i] + ", expected a finite number");
            }
        }
    }
}
