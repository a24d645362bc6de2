package org.phrenic.mesh.voxel;

/**
 * The sides of quadrilaterals gathered by the edge they lie on: side {@code 4 q + s} runs from corner s of
 * quadrilateral q to the next. Those of one edge follow each other in {@link #order}, edges by their lower, then higher
 * vertex.
 */
final class QuadEdges {
    private final int[] quads;
    private final int[] order;

    QuadEdges(int vertices, int[] quads) {
        this.quads = quads;
        int[] start = new int[vertices + 1];
        for (int side = 0; side < quads.length; side++) {
            start[low(side) + 1]++;
        }
        for (int v = 0; v < vertices; v++) {
            start[v + 1] += start[v];
        }
        order = new int[quads.length];
        int[] filled = new int[vertices];
        for (int side = 0; side < quads.length; side++) {
            int v = low(side);
            int i = start[v] + filled[v]++;
            // A handful of sides leave a vertex: inserting them by the other end is as fast as any sorting.
            while (i > start[v] && high(order[i - 1]) > high(side)) {
                order[i] = order[i - 1];
                i--;
            }
            order[i] = side;
        }
    }

    int from(int side) {
        return quads[side];
    }

    int to(int side) {
        return quads[(side & 3) == 3 ? side - 3 : side + 1];
    }

    int low(int side) {
        return Math.min(from(side), to(side));
    }

    int high(int side) {
        return Math.max(from(side), to(side));
    }

    /** Sides, those of one edge together. */
    int[] order() {
        return order;
    }

    /** The place in {@link #order} after the last side of the edge that begins at {@code place}. */
    int end(int place) {
        int low = low(order[place]);
        int high = high(order[place]);
        int end = place + 1;
        while (end < order.length && low(order[end]) == low && high(order[end]) == high) {
            end++;
        }
        return end;
    }
}
