package org.phrenic.mesh.io.volume;

import java.math.BigInteger;
import java.util.Arrays;
import java.util.function.IntConsumer;

/**
 * Fills closed polygons on a grid of columns and rows by the even-odd rule: an inner polygon cuts a hole, and a
 * keyhole's two edges cancel. A point is inside if the ray from it to smaller columns crosses edges an odd number of
 * times; an edge counts from its lower row, inclusive, to its upper row, exclusive.
 */
final class ContourFill {
    private final int columns;
    private final int rows;
    private final boolean[] crossings;
    private final boolean[] passed;
    private int firstRow;
    private int lastRow;

    ContourFill(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
        crossings = new boolean[Math.multiplyExact(columns, rows)];
        passed = new boolean[crossings.length];
        clear();
    }

    private void clear() {
        firstRow = rows;
        lastRow = -1;
    }

    /** Adds a polygon. @param xy columns and rows of its corners in turn */
    void add(double[] xy) {
        int corners = xy.length / 2;
        for (int c = 0; c < corners; c++) {
            int next = (c + 1) % corners;
            edge(xy[2 * c], xy[2 * c + 1], xy[2 * next], xy[2 * next + 1]);
        }
    }

    /**
     * Adds an outline through the centres of the outermost pixels of a structure, or of those around a hole in it: the
     * points that it passes are inside as well.
     *
     * @param xy columns and rows of its corners in turn, whole numbers
     */
    void addThroughPoints(double[] xy) {
        add(xy);
        int corners = xy.length / 2;
        for (int c = 0; c < corners; c++) {
            int next = (c + 1) % corners;
            pass((int) xy[2 * c], (int) xy[2 * c + 1], (int) xy[2 * next], (int) xy[2 * next + 1]);
        }
    }

    private void pass(int x1, int y1, int x2, int y2) {
        int steps = Math.max(
                1, BigInteger.valueOf(x2 - x1).gcd(BigInteger.valueOf(y2 - y1)).intValue());
        for (int step = 0; step < steps; step++) {
            int column = x1 + (x2 - x1) / steps * step;
            int row = y1 + (y2 - y1) / steps * step;
            if (column >= 0 && column < columns && row >= 0 && row < rows) {
                passed[column + columns * row] = true;
                firstRow = Math.min(firstRow, row);
                lastRow = Math.max(lastRow, row);
            }
        }
    }

    private void edge(double x1, double y1, double x2, double y2) {
        int from = (int) Math.max(0, Math.ceil(Math.min(y1, y2)));
        int to = (int) Math.min(rows, Math.ceil(Math.max(y1, y2)));
        for (int row = from; row < to; row++) {
            double x = x1 + (row - y1) * (x2 - x1) / (y2 - y1);
            int column = (int) Math.max(0, Math.ceil(x));
            if (column < columns) {
                crossings[column + columns * row] ^= true;
            }
        }
        firstRow = Math.min(firstRow, from);
        lastRow = Math.max(lastRow, to - 1);
    }

    /** Calls {@code inside} for each point inside, by its index column + columns row, and forgets the polygons. */
    void flush(IntConsumer inside) {
        for (int row = firstRow; row <= lastRow; row++) {
            boolean in = false;
            for (int n = columns * row; n < columns * (row + 1); n++) {
                in ^= crossings[n];
                if (in || passed[n]) {
                    inside.accept(n);
                }
            }
            Arrays.fill(crossings, columns * row, columns * (row + 1), false);
            Arrays.fill(passed, columns * row, columns * (row + 1), false);
        }
        clear();
    }
}
