package org.phrenic.engine.math;

/** Stable argsort: the permutation that sorts keys in ascending order, without boxing. */
public final class ArgSort {
    private ArgSort() {}

    /** Indices of the keys in ascending order; equal keys keep their order. */
    public static int[] of(long[] keys) {
        long[] sorted = keys.clone();
        RadixSort.sort(sorted);
        int[] order = new int[keys.length];
        int[] taken = new int[keys.length];
        for (int i = 0; i < keys.length; i++) {
            int first = firstOf(sorted, keys[i]);
            order[first + taken[first]++] = i;
        }
        return order;
    }

    /** Index of the first occurrence of a key that is present. */
    private static int firstOf(long[] sorted, long key) {
        int low = 0;
        int high = sorted.length - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sorted[middle] < key) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
