package org.phrenic.engine.math;

import java.util.Arrays;

/**
 * Disjoint sets as a forest: each item names another of its set, the root itself (union-find with path halving; Tarjan
 * and van Leeuwen 1984, doi 10.1145/62.2160).
 */
public final class DisjointSets {
    private DisjointSets() {}

    /** So many items, each a set of its own. */
    public static int[] singletons(int count) {
        int[] parent = new int[count];
        Arrays.setAll(parent, i -> i);
        return parent;
    }

    /** The root of an item's set; shortens the way for those who come after. */
    public static int find(int[] parent, int item) {
        int at = item;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }

    /**
     * Makes one set of two items' sets, whose root is the lower of the two roots: of sets joined so alone it is the
     * lowest item.
     */
    public static void unionToLower(int[] parent, int a, int b) {
        int one = find(parent, a);
        int other = find(parent, b);
        parent[Math.max(one, other)] = Math.min(one, other);
    }
}
