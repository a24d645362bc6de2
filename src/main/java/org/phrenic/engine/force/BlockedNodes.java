package org.phrenic.engine.force;

import java.util.Arrays;
import org.phrenic.engine.NodeLayout;

/** A list of nodes sorted by block: which of the caller's entries fall into a block. */
final class BlockedNodes {
    /** Entries of block b are {@code [start[b], start[b+1])}. */
    final int[] start;
    /** Internal node of an entry times 3. */
    final int[] node;
    /** Which of the caller's list an entry is. */
    final int[] item;

    BlockedNodes(NodeLayout layout, int[] callerNodes) {
        long[] key = new long[callerNodes.length];
        for (int i = 0; i < key.length; i++) {
            key[i] = (long) layout.internal(callerNodes[i]) << 32 | i;
        }
        Arrays.sort(key);
        start = new int[layout.blockCount() + 1];
        node = new int[key.length];
        item = new int[key.length];
        for (int i = 0; i < key.length; i++) {
            int internal = (int) (key[i] >>> 32);
            node[i] = 3 * internal;
            item[i] = (int) key[i];
            start[layout.blockOf(internal) + 1]++;
        }
        for (int b = 0; b < layout.blockCount(); b++) {
            start[b + 1] += start[b];
        }
    }

    int count() {
        return node.length;
    }
}
