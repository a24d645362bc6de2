package org.phrenic.mesh.voxel;

import org.phrenic.mesh.EdgeTable;

/**
 * Neighbours for smoothing a {@link SurfaceNet}, in compressed rows. They are the vertices joined by an edge. A vertex
 * on a line where three or more parts meet has only its neighbours along that line.
 *
 * @param start neighbours of vertex v are {@code neighbours[start[v]]} to {@code neighbours[start[v + 1] - 1]}
 */
record SurfaceNetNeighbours(int[] start, int[] neighbours) {
    /**
     * Finds the neighbours in a net.
     *
     * @param quads four vertices per face
     * @param parts two parts per face, one for each side
     */
    static SurfaceNetNeighbours of(int vertices, int[] quads, short[] parts) {
        EdgeTable table = new EdgeTable(vertices, quads, 4);
        int[] ends = table.edges();
        boolean[] line = new boolean[table.edgeCount()];
        int[] start = new int[vertices + 1];
        int[] onLine = new int[vertices];
        for (int k = 0; k < ends.length; k++) {
            line[k / 2] = k % 2 == 0 ? isLine(table, k / 2, parts) : line[k / 2];
            start[ends[k] + 1]++;
            onLine[ends[k]] += line[k / 2] ? 1 : 0;
        }
        for (int v = 0; v < vertices; v++) {
            start[v + 1] = start[v] + (onLine[v] > 1 ? onLine[v] : start[v + 1]);
        }
        int[] neighbours = new int[start[vertices]];
        int[] filled = new int[vertices];
        for (int k = 0; k < ends.length; k++) {
            int v = ends[k];
            if (line[k / 2] || onLine[v] < 2) {
                neighbours[start[v] + filled[v]++] = ends[k ^ 1];
            }
        }
        return new SurfaceNetNeighbours(start, neighbours);
    }

    /** Whether three or more parts meet at an edge. */
    private static boolean isLine(EdgeTable table, int edge, short[] parts) {
        int first = 2 * table.face(edge, 0);
        for (int i = 1; i < table.faceCount(edge); i++) {
            int face = 2 * table.face(edge, i);
            for (int k = face; k < face + 2; k++) {
                if (parts[k] != parts[first] && parts[k] != parts[first + 1]) {
                    return true;
                }
            }
        }
        return false;
    }
}
