package org.phrenic.geometry;

import java.util.Arrays;

/**
 * Distances along the edges of a mesh (Dijkstra 1959, doi 10.1007/BF01386390). A path along edges is never shorter than the
 * geodesic on the surface; on equilateral triangles it is longer by at most 2 / sqrt(3) - 1 = 15 %.
 */
public final class Geodesics {
    private Geodesics() {}

    /**
     * Distance of every vertex from the nearest source along edges, mm; infinite where no path leads.
     *
     * @param sources vertices at distance 0, at least one
     * @throws IllegalArgumentException if there is no source or one is no vertex of the mesh
     */
    public static double[] distances(TriangleMesh mesh, MeshTopology topology, int... sources) {
        if (sources.length == 0) {
            throw new IllegalArgumentException("geodesic sources: none given, expected at least one vertex");
        }
        int count = mesh.vertexCount();
        double[] distance = new double[count];
        Arrays.fill(distance, Double.POSITIVE_INFINITY);
        double[] lengths = MeshMeasure.edgeLengths(mesh, topology);
        VertexHeap heap = new VertexHeap(distance);
        for (int source : sources) {
            if (source < 0 || source >= count) {
                throw new IllegalArgumentException(
                        "geodesic source " + source + ", expected a vertex from 0 to " + (count - 1));
            }
            distance[source] = 0;
            heap.lower(source);
        }
        int[] start = topology.vertexEdgeStart();
        int[] edges = topology.vertexEdges();
        while (!heap.isEmpty()) {
            int v = heap.takeNearest();
            for (int k = start[v]; k < start[v + 1]; k++) {
                int other = topology.otherVertex(edges[k], v);
                double along = distance[v] + lengths[edges[k]];
                if (along < distance[other]) {
                    distance[other] = along;
                    heap.lower(other);
                }
            }
        }
        return distance;
    }

    /** A binary heap of vertices by distance, in which a vertex's distance may fall. */
    private static final class VertexHeap {
        private static final int ABSENT = -1;
        private final double[] key;
        private final int[] heap;
        private final int[] place;
        private int size;

        VertexHeap(double[] key) {
            this.key = key;
            heap = new int[key.length];
            place = new int[key.length];
            Arrays.fill(place, ABSENT);
        }

        boolean isEmpty() {
            return size == 0;
        }

        /** Enters the vertex, or moves it up after its distance fell. */
        void lower(int vertex) {
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

        int takeNearest() {
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
}
