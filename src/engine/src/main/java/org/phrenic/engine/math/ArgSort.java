package org.phrenic.engine.math;

/** The order of keys by size, of equal ones the earlier first; without boxed numbers. */
public final class ArgSort {
    private ArgSort() {}

    /** Which key comes first, which second, and so on. */
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

    /** The first place of a key that is there. */
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
