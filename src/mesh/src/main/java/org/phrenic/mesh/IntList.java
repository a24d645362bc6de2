package org.phrenic.mesh;

import java.util.Arrays;

/** A growable list of integers without boxing; also a stack. */
public final class IntList {
    private int[] values = new int[64];
    private int size;

    public void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, (int) Math.min(2L * size, Integer.MAX_VALUE - 8));
        }
        values[size++] = value;
    }

    public int get(int index) {
        return values[index];
    }

    /** Removes and returns the last number; the list must not be empty. */
    public int removeLast() {
        return values[--size];
    }

    public int size() {
        return size;
    }

    public boolean isEmpty() {
        return size == 0;
    }

    public int[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
