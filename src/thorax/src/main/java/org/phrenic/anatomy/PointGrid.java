package org.phrenic.anatomy;

import org.phrenic.mesh.BoundingBoxes;

/**
 * Points in cubic cells, for finding neighbours within one cell's size. Cells are numbered along z fastest, so the 27
 * cells round a point are nine rows of three whose points are consecutive.
 */
final class PointGrid {
    private final int[] row;
    private final int[] cellOf;
    private final int[] start;
    private final int[] point;

    /**
     * @param positions three numbers a point, mm
     * @param size of a cell, mm
     */
    PointGrid(double[] positions, double size) {
        double[] box = new double[6];
        BoundingBoxes.setEmpty(box, 0);
        for (int i = 0; i < positions.length; i += 3) {
            BoundingBoxes.include(box, 0, positions, i);
        }
        // A layer of empty cells all round, so that every point has all its neighbours.
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

    /** First place of row 0 to 8 of the neighbourhood of a point. */
    int rowStart(int of, int number) {
        return start[cellOf[of] + row[number] - 1];
    }

    /** One past the last place of a row. */
    int rowEnd(int of, int number) {
        return start[cellOf[of] + row[number] + 2];
    }

    /** The point at a place. */
    int point(int place) {
        return point[place];
    }
}
