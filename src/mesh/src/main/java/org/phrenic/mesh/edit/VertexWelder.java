package org.phrenic.mesh.edit;

import java.util.Arrays;
import org.phrenic.mesh.Vectors;

/** Finds the nearest earlier kept vertex within a distance for each vertex in turn, with a hashed grid. */
final class VertexWelder {
    /** Cell edge in tolerances; a vertex then searches 3.4 cells on average instead of 27. */
    private static final double CELL = 4;
    /** Search distance in tolerances, with a margin for rounding. */
    private static final double REACH = 1.01;
    /** Index of the last cell in each direction; coordinates beyond it share this cell. */
    private static final double LAST_CELL = 0x1p62;

    private final double[] positions;
    private final double tolerance;
    private final int[] head;
    private final int[] chain;

    VertexWelder(double[] positions, double tolerance) {
        this.positions = positions;
        this.tolerance = tolerance;
        int count = positions.length / 3;
        head = new int[Math.max(16, Integer.highestOneBit(Math.max(1, count)) * 4)];
        chain = new int[count];
        Arrays.fill(head, -1);
    }

    /** The representative of each vertex; a kept vertex is its own representative. */
    int[] representatives() {
        int count = chain.length;
        int[] keeper = new int[count];
        double reach = REACH * tolerance;
        for (int v = 0; v < count; v++) {
            double px = positions[3 * v];
            double py = positions[3 * v + 1];
            double pz = positions[3 * v + 2];
            int best = v;
            long lastX = cellOf(px + reach);
            long lastY = cellOf(py + reach);
            long lastZ = cellOf(pz + reach);
            for (long x = cellOf(px - reach); x <= lastX; x++) {
                for (long y = cellOf(py - reach); y <= lastY; y++) {
                    for (long z = cellOf(pz - reach); z <= lastZ; z++) {
                        best = nearest(v, best, head[slot(x, y, z)]);
                    }
                }
            }
            keeper[v] = best;
            if (best == v) {
                int slot = slot(cellOf(px), cellOf(py), cellOf(pz));
                chain[v] = head[slot];
                head[slot] = v;
            }
        }
        return keeper;
    }

    /**
     * The nearest vertex to {@code v} within the tolerance, among a candidate and the chain that starts at
     * {@code first}. A candidate equal to v means that none has been found.
     */
    private int nearest(int v, int candidate, int first) {
        int best = candidate;
        double bestSquare = best == v ? tolerance * tolerance : Vectors.squaredDistance(positions, v, best);
        for (int other = first; other >= 0; other = chain[other]) {
            double square = Vectors.squaredDistance(positions, v, other);
            if (square < bestSquare || (square == bestSquare && other < best)) {
                best = other;
                bestSquare = square;
            }
        }
        return best;
    }

    /** Cell index of a coordinate. Without a tolerance it is the bit pattern of the number, with -0 mapped to 0. */
    private long cellOf(double coordinate) {
        if (!(tolerance > 0)) {
            return Double.doubleToLongBits(coordinate + 0.0);
        }
        double cell = Math.max(-LAST_CELL, Math.min(LAST_CELL, coordinate / (CELL * tolerance)));
        long cut = (long) cell;
        return cut > cell ? cut - 1 : cut;
    }

    private int slot(long x, long y, long z) {
        long h = x * 0x9E3779B97F4A7C15L ^ y * 0xC2B2AE3D27D4EB4FL ^ z * 0x165667B19E3779F9L;
        h ^= h >>> 29;
        h *= 0xBF58476D1CE4E5B9L;
        return (int) (h >>> 33) & (head.length - 1);
    }
}
