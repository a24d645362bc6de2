package org.phrenic.mesh.edit;

import java.util.Arrays;

/** Finds, for each vertex in turn, the nearest earlier kept vertex within a distance, by a hashed grid. */
final class VertexWelder {
    /**
     * Edge of a cell in tolerances: a vertex then looks into 3.4 cells in the mean and not 27, and no cell has to hold
     * many that are kept.
     */
    private static final double CELL = 4;
    /** How far a vertex looks into the next cells, in tolerances: beyond what rounding takes away. */
    private static final double REACH = 1.01;

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

    /** For each vertex the vertex that stands for it, itself if kept. */
    int[] representatives() {
        int count = chain.length;
        int[] keeper = new int[count];
        double reach = REACH * tolerance;
        for (int v = 0; v < count; v++) {
            double px = positions[3 * v];
            double py = positions[3 * v + 1];
            double pz = positions[3 * v + 2];
            int best = v;
            double bestSquare = tolerance * tolerance;
            for (long x = cellOf(px - reach); x <= cellOf(px + reach); x++) {
                for (long y = cellOf(py - reach); y <= cellOf(py + reach); y++) {
                    for (long z = cellOf(pz - reach); z <= cellOf(pz + reach); z++) {
                        for (int other = head[slot(x, y, z)]; other >= 0; other = chain[other]) {
                            double square = squareDistance(v, other);
                            if (square < bestSquare || (square == bestSquare && other < best)) {
                                best = other;
                                bestSquare = square;
                            }
                        }
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

    /** With no tolerance a cell is one number, whose bits name it; -0 is 0. */
    private long cellOf(double coordinate) {
        if (!(tolerance > 0)) {
            return Double.doubleToLongBits(coordinate + 0.0);
        }
        double cell = coordinate / (CELL * tolerance);
        long cut = (long) cell;
        return cut > cell ? cut - 1 : cut;
    }

    private int slot(long x, long y, long z) {
        long h = x * 0x9E3779B97F4A7C15L ^ y * 0xC2B2AE3D27D4EB4FL ^ z * 0x165667B19E3779F9L;
        h ^= h >>> 29;
        h *= 0xBF58476D1CE4E5B9L;
        return (int) (h >>> 33) & (head.length - 1);
    }

    private double squareDistance(int a, int b) {
        double dx = positions[3 * a] - positions[3 * b];
        double dy = positions[3 * a + 1] - positions[3 * b + 1];
        double dz = positions[3 * a + 2] - positions[3 * b + 2];
        return dx * dx + dy * dy + dz * dz;
    }
}
