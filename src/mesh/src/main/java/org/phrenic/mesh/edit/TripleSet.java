package org.phrenic.mesh.edit;

import java.util.Arrays;

/** A set of unordered vertex triples: an open-addressing hash set in flat arrays with fixed capacity. */
final class TripleSet {
    private final int[] slots;
    private final int[] triples;
    private int size;

    TripleSet(int capacity) {
        slots = new int[Math.max(16, Integer.highestOneBit(Math.max(1, capacity)) * 4)];
        triples = new int[3 * capacity];
        Arrays.fill(slots, -1);
    }

    /** Adds the triple; returns false if the set already contains it in any order. */
    boolean add(int a, int b, int c) {
        int low = Math.min(a, Math.min(b, c));
        int high = Math.max(a, Math.max(b, c));
        int middle = a ^ b ^ c ^ low ^ high;
        long h = low * 0x9E3779B97F4A7C15L ^ middle * 0xC2B2AE3D27D4EB4FL ^ high * 0x165667B19E3779F9L;
        h ^= h >>> 31;
        int slot = (int) h & (slots.length - 1);
        while (slots[slot] >= 0) {
            int k = 3 * slots[slot];
            if (triples[k] == low && triples[k + 1] == middle && triples[k + 2] == high) {
                return false;
            }
            slot = (slot + 1) & (slots.length - 1);
        }
        slots[slot] = size;
        triples[3 * size] = low;
        triples[3 * size + 1] = middle;
        triples[3 * size + 2] = high;
        size++;
        return true;
    }
}
