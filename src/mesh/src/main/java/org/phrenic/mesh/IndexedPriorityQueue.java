package org.phrenic.mesh;

import java.util.Arrays;

/**
 * An indexed binary min-heap of vertices for Dijkstra's algorithm (1959, doi 10.1007/BF01386390). The keys are
 * distances in an array that the caller modifies.
 */
public final class IndexedPriorityQueue {
    private static final int ABSENT = -1;
    private final double[] key;
    private final int[] heap;
    private final int[] place;
    private int size;

    /** An empty heap over the keys, one per vertex. */
    public IndexedPriorityQueue(double[] key) {
        this.key = key;
        heap = new int[key.length];
        place = new int[key.length];
        Arrays.fill(place, ABSENT);
    }

    public boolean isEmpty() {
        return size == 0;
    }

    /** Inserts a vertex, or restores the heap order after its key has decreased. */
    public void insertOrDecrease(int vertex) {
        int i = place[vertex] == ABSENT ? size++ : place[vertex];
        while (i > 0) {
            int parent = (i - 1) >>> 1;
            if (key[heap[parent]] <= key[vertex]) {
                break;
            }
            put(i, heap[parent]);
            i = parent;
        }
        put(i, vertex);
    }

    /** Removes and returns the vertex with the least key; the heap must not be empty. */
    public int removeMin() {
        int nearest = heap[0];
        place[nearest] = ABSENT;
        int last = heap[--size];
        if (size == 0) {
            return nearest;
        }
        int i = 0;
        while (2 * i + 1 < size) {
            int below = 2 * i + 1;
            if (below + 1 < size && key[heap[below + 1]] < key[heap[below]]) {
                below++;
            }
            if (key[heap[below]] >= key[last]) {
                break;
            }
            put(i, heap[below]);
            i = below;
        }
        put(i, last);
        return nearest;
    }

    private void put(int i, int vertex) {
        heap[i] = vertex;
        place[vertex] = i;
    }
}
