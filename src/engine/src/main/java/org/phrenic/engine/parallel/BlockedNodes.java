package org.phrenic.engine.parallel;

import java.util.stream.IntStream;

/** A list of nodes sorted by block, with the entries of each block. */
public final class BlockedNodes {
    /** Entries of block b are {@code [start[b], start[b+1])}. */
    public final int[] start;
    /** Internal node of an entry times 3. */
    public final int[] node;
    /** Index of each entry in the caller's list. */
    public final int[] item;

    private final boolean sorted;

    public BlockedNodes(NodeLayout layout, int[] callerNodes) {
        item = layout.inMemoryOrder(callerNodes);
        sorted = IntStream.range(0, item.length).allMatch(i -> item[i] == i);
        start = new int[layout.blockCount() + 1];
        node = new int[item.length];
        for (int i = 0; i < item.length; i++) {
            int internal = layout.internal(callerNodes[item[i]]);
            node[i] = 3 * internal;
            start[layout.blockOf(internal) + 1]++;
        }
        for (int b = 0; b < layout.blockCount(); b++) {
            start[b + 1] += start[b];
        }
    }

    /** Whether the caller's list is already in the order of entries. */
    public boolean isSorted() {
        return sorted;
    }

    /** Copies three values a node from the caller's order to the order of entries. */
    public void toEntries(double[] listed, double[] sorted) {
        for (int i = 0; i < item.length; i++) {
            int p = 3 * item[i];
            sorted[3 * i] = listed[p];
            sorted[3 * i + 1] = listed[p + 1];
            sorted[3 * i + 2] = listed[p + 2];
        }
    }

    public int count() {
        return node.length;
    }
}
