package org.phrenic.geometry;

import java.util.Arrays;

/**
 * Items in sets that do not overlap, as an array in which each item names another of its set and one, the root, itself (union and find with the way halved; Tarjan and van Leeuwen 1984, doi 10.1145/62.2160).
 */
public final class DisjointSets {
    private DisjointSets() {}

    /** So many items, each a set of its own. */
    public static int[] alone(int count) {
        int[] parent = new int[count];
        Arrays.setAll(parent, i -> i);
        return parent;
    }

    /** The root of an item's set; shortens the way for those who come after. */
    public static int root(int[] parent, int item) {
        int at = item;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }

    /** Makes one set of two items' sets, whose root is the lower of the two roots: of sets joined so alone it is the lowest item. */
    public static void joinUnderLower(int[] parent, int a, int b) {
        int one = root(parent, a);
        int other = root(parent, b);
        parent[Math.max(one, other)] = Math.min(one, other);
    }
}
