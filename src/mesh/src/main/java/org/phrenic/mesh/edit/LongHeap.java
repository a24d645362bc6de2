package org.phrenic.mesh.edit;

import java.util.Arrays;

/** A binary min-heap of longs without boxing. Equal keys may be entered several times. */
final class LongHeap {
    private long[] keys = new long[1 << 10];
    private int size;

    boolean isEmpty() {
        return size == 0;
    }

    void add(long key) {
        if (size == keys.length) {
            keys = Arrays.copyOf(keys, 2 * size);
        }
        int i = size++;
        while (i > 0 && keys[(i - 1) >>> 1] > key) {
            keys[i] = keys[(i - 1) >>> 1];
            i = (i - 1) >>> 1;
        }
        keys[i] = key;
    }

    /** Removes and returns the least key; the heap must not be empty. */
    long poll() {
        long least = keys[0];
        long last = keys[--size];
        int i = 0;
        while (2 * i + 1 < size) {
            int child = 2 * i + 1;
            child += child + 1 < size && keys[child + 1] < keys[child] ? 1 : 0;
            if (last <= keys[child]) {
                break;
            }
            keys[i] = keys[child];
            i = child;
        }
        keys[i] = last;
        return least;
    }
}
