package org.phrenic.engine;

import java.util.Arrays;
import java.util.List;
import org.phrenic.engine.math.DisjointSets;

/** Constraint islands: sets of nodes connected by constraint items. An island is identified by its lowest node. */
final class ConstraintIslands {
    private final int[] parent;
    private final int[] itemCount;
    private final int[] size;
    private int pieceCount;

    ConstraintIslands(List<SeparableConstraint> constraints, int nodeCount) {
        parent = DisjointSets.singletons(nodeCount);
        itemCount = new int[nodeCount];
        size = new int[nodeCount];
        for (SeparableConstraint each : constraints) {
            int[][] ends = each.itemNodes();
            for (int i = 0; i < ends[0].length; i++) {
                for (int[] end : ends) {
                    DisjointSets.unionToLower(parent, ends[0][i] / 3, end[i] / 3);
                }
            }
        }
        for (int i = 0; i < nodeCount; i++) {
            size[islandOf(i)]++;
        }
        for (SeparableConstraint each : constraints) {
            for (int first : each.itemNodes()[0]) {
                itemCount[islandOf(first / 3)]++;
            }
        }
    }

    /** The island of a node, as its lowest node. */
    int islandOf(int node) {
        return DisjointSets.find(parent, node);
    }

    /** Number of nodes of the largest island. */
    int largestSize() {
        return Arrays.stream(size).max().orElse(0);
    }

    /** Number of items in the island of a node. */
    int itemCount(int node) {
        return itemCount[islandOf(node)];
    }

    /**
     * The piece of each node. Islands are taken in the order of their lowest nodes, so that a piece is contiguous in
     * memory.
     */
    int[] assignPieces(int nodesAPiece) {
        int[] piece = new int[parent.length];
        int current = 0;
        int filled = 0;
        for (int i = 0; i < parent.length; i++) {
            if (islandOf(i) != i) {
                piece[i] = piece[islandOf(i)];
                continue;
            }
            if (filled >= nodesAPiece) {
                current++;
                filled = 0;
            }
            piece[i] = current;
            filled += itemCount[i] > 0 ? size[i] : 0;
        }
        pieceCount = current + 1;
        return piece;
    }

    int pieceCount() {
        return pieceCount;
    }
}
