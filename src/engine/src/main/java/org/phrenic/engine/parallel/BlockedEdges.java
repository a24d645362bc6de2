package org.phrenic.engine.parallel;

import java.util.Arrays;
import org.phrenic.engine.math.RadixSort;

/**
 * Edges between nodes, sorted by block. An edge with both ends in one block is listed once ("inner"). An edge between
 * two blocks is listed in each of them ("outer", from the node in that block). The force of an inner edge is thus
 * computed once for both ends, no two blocks write to the same node, and the order of summation is fixed.
 */
public final class BlockedEdges {
    private static final int SWEEPS = 8;

    /** Internal nodes of the edges in the caller's order. */
    public final int[] nodeA;

    public final int[] nodeB;
    /**
     * Index ranges of entries: inner {@code [innerStart(b), outerStart(b))}, outer {@code [outerStart(b),
     * innerStart(b+1))}.
     */
    public final int[] innerStart;

    /**
     * Inner entries before this index are in groups of three with the same first node (stars); those from here on are
     * single.
     */
    public final int[] singleStart;

    public final int[] outerStart;
    /** First node of the entry times 3; for an outer entry, the node in the block. */
    public final int[] own;
    /** Second node of the entry times 3. */
    public final int[] other;
    /** The caller's edge index of each entry. */
    public final int[] edge;

    public BlockedEdges(NodeLayout layout, int[] callerA, int[] callerB) {
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
            countEntry(e, layout, callerA[e], callerB[e], inner, outer);
        }
        innerStart = new int[blocks + 1];
        outerStart = new int[blocks];
        singleStart = new int[blocks];
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

    private void countEntry(int e, NodeLayout layout, int callerA, int callerB, int[] inner, int[] outer) {
        nodeA[e] = layout.internal(callerA);
        nodeB[e] = layout.internal(callerB);
        if (nodeA[e] == nodeB[e]) {
            throw new IllegalArgumentException(
                    "edge " + e + ": found node " + callerA + " at both ends, expected two nodes");
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

    private void fill(NodeLayout layout, int n) {
        boolean[] highOwns = owners(layout, n);
        // Sorted by first node for sequential memory access.
        long[] key = new long[n];
        int[] waiting = new int[layout.nodeCount()];
        for (int e = 0; e < n; e++) {
            int first = first(e, highOwns[e]);
            key[e] = (long) first << 32 | e;
            waiting[first] += isInner(layout, e) ? 1 : 0;
        }
        RadixSort.sort(key);
        int[] nextStar = Arrays.copyOf(innerStart, outerStart.length);
        int[] nextLoose = outerStart.clone();
        int[] nextOuter = outerStart.clone();
        int starNode = -1;
        int starLeft = 0;
        for (long k : key) {
            int e = (int) k;
            int first = (int) (k >>> 32);
            int second = nodeA[e] + nodeB[e] - first;
            int block = layout.blockOf(first);
            if (!isInner(layout, e)) {
                put(nextOuter[block]++, first, second, e);
                put(nextOuter[layout.blockOf(second)]++, second, first, e);
                continue;
            }
            if (first != starNode) {
                starNode = first;
                starLeft = waiting[first] / 3 * 3;
            }
            // Stars fill a block's inner part from its beginning, single edges from its end.
            int at = starLeft-- > 0 ? nextStar[block]++ : --nextLoose[block];
            put(at, first, second, e);
        }
        System.arraycopy(nextLoose, 0, singleStart, 0, singleStart.length);
    }

    private boolean isInner(NodeLayout layout, int e) {
        return layout.blockOf(nodeA[e]) == layout.blockOf(nodeB[e]);
    }

    private int first(int e, boolean high) {
        return high ? Math.max(nodeA[e], nodeB[e]) : Math.min(nodeA[e], nodeB[e]);
    }

    /**
     * Chooses the end of each inner edge that lists it, so that most nodes list three (a triangulated surface has three
     * edges a node) and few edges remain outside stars.
     */
    private boolean[] owners(NodeLayout layout, int n) {
        boolean[] highOwns = new boolean[n];
        int[] owned = new int[layout.nodeCount()];
        for (int e = 0; e < n; e++) {
            if (isInner(layout, e)) {
                highOwns[e] = owned[first(e, true)] < owned[first(e, false)];
                owned[first(e, highOwns[e])]++;
            }
        }
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            for (int e = 0; e < n; e++) {
                if (isInner(layout, e)) {
                    swapOwner(e, highOwns, owned);
                }
            }
        }
        return highOwns;
    }

    /** Reassigns an edge to its other end if fewer edges then remain outside stars. */
    private void swapOwner(int e, boolean[] highOwns, int[] owned) {
        int mine = first(e, highOwns[e]);
        int theirs = first(e, !highOwns[e]);
        int before = owned[mine] % 3 + owned[theirs] % 3;
        int after = (owned[mine] + 2) % 3 + (owned[theirs] + 1) % 3;
        // Neutral reassignments are accepted as well, because they may complete a star elsewhere.
        if (after < before || (after == before && owned[mine] % 3 == 1)) {
            highOwns[e] = !highOwns[e];
            owned[mine]--;
            owned[theirs]++;
        }
    }

    private void put(int at, int ownNode, int otherNode, int e) {
        own[at] = 3 * ownNode;
        other[at] = 3 * otherNode;
        edge[at] = e;
    }

    public int count() {
        return nodeA.length;
    }

    /** Copies one value for each edge to one value for each entry. */
    public double[] toEntries(double[] perEdge) {
        double[] out = new double[edge.length];
        for (int i = 0; i < edge.length; i++) {
            out[i] = perEdge[edge[i]];
        }
        return out;
    }
}
