package org.phrenic.file;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** Texts and numbers in an entry of a {@link UserCache}. A text is an int32 length and UTF-8, a number a float64. */
public final class EntryContent {
    private EntryContent() {}

    /** Number of bytes of a text. */
    public static int size(String text) {
        return Integer.BYTES + bytes(text).length;
    }

    public static void put(ByteBuffer out, String text) {
        out.putInt(bytes(text).length).put(bytes(text));
    }

    public static void put(ByteBuffer out, double[] numbers) {
        out.asDoubleBuffer().put(numbers);
        out.position(out.position() + Double.BYTES * numbers.length);
    }

    /**
     * The next text.
     *
     * @throws java.nio.BufferUnderflowException if it is longer than the rest of the entry
     * @throws NegativeArraySizeException if its length is negative
     */
    public static String text(ByteBuffer in) {
        byte[] text = new byte[in.getInt()];
        in.get(text);
        return new String(text, StandardCharsets.UTF_8);
    }

    /**
     * The next numbers.
     *
     * @throws java.nio.BufferUnderflowException if the rest of the entry has less
     * @throws NegativeArraySizeException if the count is negative
     */
    public static double[] numbers(ByteBuffer in, int count) {
        double[] numbers = new double[count];
        in.asDoubleBuffer().get(numbers);
        in.position(in.position() + Double.BYTES * count);
        return numbers;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
