package org.phrenic.mesh.io;

import java.util.Arrays;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.InputLocator;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;

/**
 * Reader of the cell sections of a legacy VTK file in both layouts. In the classic layout each cell is its length
 * followed by its points. From version 5.1 a section has OFFSETS and CONNECTIVITY.
 */
record VtkCells(ByteCursor cursor, boolean offsetLayout) {
    /** Receives the points of one cell, {@code points[from..to)}. */
    interface Cells {
        void add(InputLocator source, long[] points, int from, int to);
    }

    /** Reads one section. */
    void read(Cells out) {
        int first = cursor.count("the number of cells");
        int second = cursor.count("the size of the cells");
        cursor.lineOrNull();
        if (offsetLayout) {
            readOffsetLayout(out, first, second);
        } else {
            readClassic(out, first, second);
        }
    }

    private void readClassic(Cells out, int cells, int size) {
        cursor.requireValues(size, ScalarType.INT32, cells + " cells");
        long left = size;
        for (int c = 0; c < cells; c++) {
            long length = cursor.readLong(ScalarType.INT32, "the number of points of a cell");
            left -= length + 1;
            if (length < 0 || left < 0) {
                throw cursor.badInput("found a cell of " + length + " points, expected the cells to fill " + size
                        + " numbers together");
            }
            long[] points = new long[(int) length];
            for (int i = 0; i < length; i++) {
                points[i] = cursor.readLong(ScalarType.INT32, "a point index");
            }
            out.add(cursor, points, 0, points.length);
        }
        if (left != 0) {
            throw cursor.badInput("found cells that leave " + left + " of " + size + " numbers, expected none left");
        }
    }

    private void readOffsetLayout(Cells out, int offsetCount, int connectivityCount) {
        if (offsetCount == 0) {
            return;
        }
        long[] offsets = array("OFFSETS", offsetCount);
        long offsetsPlace = cursor.location();
        long[] connectivity = array("CONNECTIVITY", connectivityCount);
        if (offsets[0] != 0 || offsets[offsetCount - 1] != connectivityCount) {
            String found = "found offsets from " + offsets[0] + " to " + offsets[offsetCount - 1];
            throw cursor.badInput(offsetsPlace, found + ", expected 0 to " + connectivityCount);
        }
        for (int c = 0; c + 1 < offsetCount; c++) {
            if (offsets[c + 1] < offsets[c] || offsets[c + 1] > connectivityCount) {
                String found = "found offset " + offsets[c + 1] + " after " + offsets[c];
                throw cursor.badInput(offsetsPlace, found + ", expected offsets that grow up to " + connectivityCount);
            }
            out.add(cursor, connectivity, (int) offsets[c], (int) offsets[c + 1]);
        }
    }

    private long[] array(String keyword, int count) {
        cursor.expect(keyword);
        String typeName = cursor.word("the type of " + keyword);
        ScalarType type = VtkReader.type(cursor, typeName);
        if (!type.isInteger()) {
            throw cursor.badInput("found type " + Numbers.quote(typeName) + ", expected whole numbers for " + keyword);
        }
        cursor.lineOrNull();
        cursor.requireValues(count, type, count + " numbers of " + keyword);
        long[] values = new long[count];
        Arrays.setAll(values, i -> cursor.readLong(type, "a number of " + keyword));
        return values;
    }
}
