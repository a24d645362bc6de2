package org.phrenic.mesh;

import java.util.Arrays;

/**
 * An indexed binary heap of vertices by distance, for Dijkstra's method (1959, doi 10.1007/BF01386390). The caller
 * changes the distances in a shared array.
 */
public final class IndexedPriorityQueue {
    private static final int ABSENT = -1;
    private final double[] key;
    private final int[] heap;
    private final int[] place;
    private int size;

    /** An empty heap over these distances, one a vertex. */
    public IndexedPriorityQueue(double[] key) {
        this.key = key;
        heap = new int[key.length];
        place = new int[key.length];
        Arrays.fill(place, ABSENT);
    }

    public boolean isEmpty() {
        return size == 0;
    }

    /** Enters the vertex, or moves it up after its distance fell. */
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

    /** Takes the vertex of least distance out; the heap must not be empty. */
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
