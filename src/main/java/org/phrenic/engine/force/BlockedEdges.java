package org.phrenic.engine.force;

import java.util.Arrays;
import org.phrenic.engine.NodeLayout;

/**
 * Edges between nodes sorted for block-wise work: an edge with both ends in one block is listed once there ("inner"), an edge between two blocks once in each of them
 * ("outer", seen from its own node). So the force of an inner edge is computed once and given to both ends, no two blocks write to the same node, and the order
 * of summation is fixed.
 */
final class BlockedEdges {
    /** Edges as the caller listed them, in internal nodes. */
    final int[] nodeA;

    final int[] nodeB;
    /** Places in the sorted list: {@code [innerStart(b), outerStart(b))} inner, {@code [outerStart(b), innerStart(b+1))} outer. */
    final int[] innerStart;

    final int[] outerStart;
    /** First node of the entry times 3; for an outer entry the one in the block. */
    final int[] own;
    /** Other node of the entry times 3. */
    final int[] other;
    /** Which of the caller's edges an entry is. */
    final int[] edge;

    BlockedEdges(NodeLayout layout, int[] callerA, int[] callerB) {
        if (callerA.length != callerB.length) {
            throw new IllegalArgumentException(
                    "edges: found " + callerA.length + " and " + callerB.length + " ends, expected as many");
        }
        int n = callerA.length;
        nodeA = new int[n];
        nodeB = new int[n];
        int blocks = layout.blockCount();
        int[] inner = new int[blocks];
        int[] outer = new int[blocks];
        for (int e = 0; e < n; e++) {
            nodeA[e] = layout.internal(callerA[e]);
            nodeB[e] = layout.internal(callerB[e]);
            if (nodeA[e] == nodeB[e]) {
                throw new IllegalArgumentException(
                        "edge " + e + ": found node " + callerA[e] + " at both ends, expected two nodes");
            }
            int a = layout.blockOf(nodeA[e]);
            int b = layout.blockOf(nodeB[e]);
            if (a == b) {
                inner[a]++;
            } else {
                outer[a]++;
                outer[b]++;
            }
        }
        innerStart = new int[blocks + 1];
        outerStart = new int[blocks];
        for (int b = 0; b < blocks; b++) {
            outerStart[b] = innerStart[b] + inner[b];
            innerStart[b + 1] = outerStart[b] + outer[b];
        }
        int entries = innerStart[blocks];
        own = new int[entries];
        other = new int[entries];
        edge = new int[entries];
        fill(layout, n);
    }

    private void fill(NodeLayout layout, int n) {
        int[] nextInner = Arrays.copyOf(innerStart, innerStart.length);
        int[] nextOuter = outerStart.clone();
        // Sorted by first node, so that entries walk through memory.
        long[] key = new long[n];
        for (int e = 0; e < n; e++) {
            key[e] = (long) Math.min(nodeA[e], nodeB[e]) << 32 | e;
        }
        Arrays.sort(key);
        for (long k : key) {
            int e = (int) k;
            int low = Math.min(nodeA[e], nodeB[e]);
            int high = Math.max(nodeA[e], nodeB[e]);
            int blockLow = layout.blockOf(low);
            int blockHigh = layout.blockOf(high);
            if (blockLow == blockHigh) {
                put(nextInner[blockLow]++, low, high, e);
            } else {
                put(nextOuter[blockLow]++, low, high, e);
                put(nextOuter[blockHigh]++, high, low, e);
            }
        }
    }

    private void put(int at, int ownNode, int otherNode, int e) {
        own[at] = 3 * ownNode;
        other[at] = 3 * otherNode;
        edge[at] = e;
    }

    int count() {
        return nodeA.length;
    }

    /** One value an edge into one value an entry. */
    double[] spread(double[] perEdge) {
        double[] out = new double[edge.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = perEdge[edge[i]];
        }
        return out;
    }
}
