package org.phrenic.anatomy;

import org.phrenic.mesh.BoundingBoxes;

/**
 * Uniform grid of points for neighbour searches within one cell size. Cells are numbered with z fastest, so that the 27
 * cells around a point form nine contiguous rows of three.
 */
final class PointGrid {
    private final int[] row;
    private final int[] cellOf;
    private final int[] start;
    private final int[] point;

    /**
     * @param positions three coordinates per point, mm
     * @param size cell size, mm
     */
    PointGrid(double[] positions, double size) {
        double[] box = new double[6];
        BoundingBoxes.around(positions, 0, positions.length, box, 0);
        // A layer of empty cells on all sides, so that every point has all neighbour cells.
        int[] cells = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            cells[axis] = positions.length == 0 ? 1 : (int) ((box[3 + axis] - box[axis]) / size) + 3;
        }
        row = new int[9];
        for (int i = 0; i < 9; i++) {
            row[i] = ((i / 3 - 1) * cells[1] + i % 3 - 1) * cells[2];
        }
        int n = positions.length / 3;
        cellOf = new int[n];
        start = new int[Math.multiplyExact(Math.multiplyExact(cells[0], cells[1]), cells[2]) + 1];
        for (int i = 0; i < n; i++) {
            int cell = 0;
            for (int axis = 0; axis < 3; axis++) {
                cell = cell * cells[axis] + 1 + (int) ((positions[3 * i + axis] - box[axis]) / size);
            }
            cellOf[i] = cell;
            start[cell + 1]++;
        }
        for (int c = 1; c < start.length; c++) {
            start[c] += start[c - 1];
        }
        point = new int[n];
        int[] next = start.clone();
        for (int i = 0; i < n; i++) {
            point[next[cellOf[i]]++] = i;
        }
    }

    /** First position of a row (0 to 8) in the neighbourhood of a point. */
    int rowStart(int of, int number) {
        return start[cellOf[of] + row[number] - 1];
    }

    /** Position after the last of a row. */
    int rowEnd(int of, int number) {
        return start[cellOf[of] + row[number] + 2];
    }

    /** Point at a position. */
    int point(int place) {
        return point[place];
    }
}
