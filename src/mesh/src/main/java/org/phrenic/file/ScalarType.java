package org.phrenic.file;

import java.nio.ByteBuffer;

/** Number types of binary files. */
public enum ScalarType {
    INT8(1),
    UINT8(1),
    INT16(2),
    UINT16(2),
    INT32(4),
    UINT32(4),
    INT64(8),
    UINT64(8),
    FLOAT32(4),
    FLOAT64(8);

    private final int size;

    ScalarType(int size) {
        this.size = size;
    }

    /** Size of a value, bytes. */
    public int size() {
        return size;
    }

    public boolean isInteger() {
        return this != FLOAT32 && this != FLOAT64;
    }

    /** The value at byte {@code at}, in the byte order of the buffer. */
    public double readDouble(ByteBuffer bytes, int at) {
        return switch (this) {
            case FLOAT32 -> bytes.getFloat(at);
            case FLOAT64 -> bytes.getDouble(at);
            default -> readLong(bytes, at);
        };
    }

    /** The integer at byte {@code at}; negative for a UINT64 of 2^63 or more. */
    public long readLong(ByteBuffer bytes, int at) {
        return switch (this) {
            case INT8 -> bytes.get(at);
            case UINT8 -> bytes.get(at) & 0xFF;
            case INT16 -> bytes.getShort(at);
            case UINT16 -> bytes.getShort(at) & 0xFFFF;
            case INT32 -> bytes.getInt(at);
            case UINT32 -> bytes.getInt(at) & 0xFFFFFFFFL;
            case INT64, UINT64 -> bytes.getLong(at);
            case FLOAT32, FLOAT64 -> throw new IllegalStateException(this + " holds no whole numbers");
        };
    }
}
