package org.phrenic.mesh.voxel;

/**
 * Which vertices of a {@link SurfaceNet} each vertex is drawn to: all along its edges; on a line where three parts or
 * more meet, those along the line.
 */
final class SurfaceNetNeighbours {
    private final int[] start;
    private final int[] neighbours;

    SurfaceNetNeighbours(int vertices, int[] quads, short[] sides) {
        QuadEdges edges = new QuadEdges(vertices, quads);
        int[] order = edges.order();
        int[] all = new int[vertices + 1];
        int[] onLine = new int[vertices];
        for (int place = 0; place < order.length; place = edges.end(place)) {
            boolean line = isLine(edges, place, sides);
            for (int v : new int[] {edges.low(order[place]), edges.high(order[place])}) {
                all[v + 1]++;
                onLine[v] += line ? 1 : 0;
            }
        }
        for (int v = 0; v < vertices; v++) {
            all[v + 1] = all[v] + (onLine[v] > 1 ? onLine[v] : all[v + 1]);
        }
        start = all;
        neighbours = new int[start[vertices]];
        int[] filled = new int[vertices];
        for (int place = 0; place < order.length; place = edges.end(place)) {
            boolean line = isLine(edges, place, sides);
            int a = edges.low(order[place]);
            int b = edges.high(order[place]);
            if (line || onLine[a] < 2) {
                neighbours[start[a] + filled[a]++] = b;
            }
            if (line || onLine[b] < 2) {
                neighbours[start[b] + filled[b]++] = a;
            }
        }
    }

    private static boolean isLine(QuadEdges edges, int place, short[] sides) {
        int one = sides[2 * (edges.order()[place] >> 2)];
        int two = sides[2 * (edges.order()[place] >> 2) + 1];
        for (int p = place + 1; p < edges.end(place); p++) {
            int quad = edges.order()[p] >> 2;
            int a = sides[2 * quad];
            int b = sides[2 * quad + 1];
            if ((a != one && a != two) || (b != one && b != two)) {
                return true;
            }
        }
        return false;
    }

    /** Neighbours of vertex v lie from start[v] to before start[v + 1]. */
    int[] start() {
        return start;
    }

    int[] neighbours() {
        return neighbours;
    }
}
