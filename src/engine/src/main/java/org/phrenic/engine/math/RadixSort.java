package org.phrenic.engine.math;

import java.util.Arrays;

/**
 * Least-significant-digit radix sort of long integers (Knuth, The Art of Computer Programming 3, 5.2.5). Digits equal
 * in all keys are skipped, which is fast for keys made of a few packed numbers. Its two short loops are compiled sooner
 * after program start than a general sort.
 */
public final class RadixSort {
    private static final int DIGIT_BITS = 11;
    private static final int DIGITS = 1 << DIGIT_BITS;
    private static final int FEW = 40;

    private RadixSort() {}

    /** Sorts keys in place, in ascending order. */
    public static void sort(long[] keys) {
        sort(keys, keys.length);
    }

    /** Sorts the first {@code length} keys in place. */
    public static void sort(long[] keys, int length) {
        if (length <= FEW) {
            insert(keys, 0, length);
            return;
        }
        long differing = differing(keys, length);
        int[] end = new int[DIGITS];
        long[] from = keys;
        long[] to = new long[length];
        for (int shift = 0; shift < Long.SIZE; shift += DIGIT_BITS) {
            if ((differing >>> shift & DIGITS - 1) == 0) {
                continue;
            }
            count(from, length, shift, end);
            scatter(from, length, shift, end, to);
            long[] swap = from;
            from = to;
            to = swap;
        }
        if (from != keys) {
            System.arraycopy(from, 0, keys, 0, length);
        }
    }

    /** Sorts the keys {@code [from, to)} in place; intended for many short ranges. */
    public static void sort(long[] keys, int from, int to) {
        if (to - from <= FEW) {
            insert(keys, from, to);
            return;
        }
        long[] stretch = Arrays.copyOfRange(keys, from, to);
        sort(stretch);
        System.arraycopy(stretch, 0, keys, from, stretch.length);
    }

    private static void insert(long[] keys, int from, int to) {
        for (int i = from + 1; i < to; i++) {
            long key = keys[i];
            int k = i - 1;
            while (k >= from && keys[k] > key) {
                keys[k + 1] = keys[k];
                k--;
            }
            keys[k + 1] = key;
        }
    }

    /** The bits in which the keys differ. */
    private static long differing(long[] keys, int length) {
        long bits = 0;
        for (int i = 1; i < length; i++) {
            bits |= keys[i] ^ keys[0];
        }
        return bits;
    }

    /** Writes to {@code start} the index of the first key with each digit. */
    private static void count(long[] keys, int length, int shift, int[] start) {
        Arrays.fill(start, 0);
        for (int i = 0; i < length; i++) {
            start[digit(keys[i], shift)]++;
        }
        int sum = 0;
        for (int d = 0; d < DIGITS; d++) {
            int count = start[d];
            start[d] = sum;
            sum += count;
        }
    }

    private static void scatter(long[] keys, int length, int shift, int[] next, long[] to) {
        for (int i = 0; i < length; i++) {
            to[next[digit(keys[i], shift)]++] = keys[i];
        }
    }

    /** The digit of a key. The sign bit is flipped, so that negative keys come first. */
    private static int digit(long key, int shift) {
        return (int) ((key ^ Long.MIN_VALUE) >>> shift) & DIGITS - 1;
    }
}
