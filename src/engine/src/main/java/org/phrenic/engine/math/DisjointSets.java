package org.phrenic.engine.math;

import java.util.Arrays;

/**
 * Union-find with path halving (Tarjan and van Leeuwen 1984, doi 10.1145/62.2160). Each item stores its parent; a root
 * stores itself.
 */
public final class DisjointSets {
    private DisjointSets() {}

    /** Creates sets of one item each. */
    public static int[] singletons(int count) {
        int[] parent = new int[count];
        Arrays.setAll(parent, i -> i);
        return parent;
    }

    /** The root of an item's set; shortens the path for later calls. */
    public static int find(int[] parent, int item) {
        int at = item;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }

    /**
     * Merges the sets of two items; the lower root becomes the root. If all unions use this method, a root is the
     * lowest item of its set.
     */
    public static void unionToLower(int[] parent, int a, int b) {
        int one = find(parent, a);
        int other = find(parent, b);
        parent[Math.max(one, other)] = Math.min(one, other);
    }
}
