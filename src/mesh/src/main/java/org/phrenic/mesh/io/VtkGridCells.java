package org.phrenic.mesh.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.InputLocator;
import org.phrenic.file.ScalarType;

/**
 * The cells of an unstructured grid in a legacy VTK file, whose types follow all of them: triangles, strips, polygons,
 * pixels and quads are the surface, points and lines are passed over.
 */
final class VtkGridCells {
    private static final int LAST_LINE = 4;
    private static final int TRIANGLE = 5;
    private static final int STRIP = 6;
    private static final int POLYGON = 7;
    private static final int PIXEL = 8;
    private static final int QUAD = 9;

    private final PolygonSoup soup;
    private final List<long[]> cells = new ArrayList<>();

    VtkGridCells(PolygonSoup soup) {
        this.soup = soup;
    }

    /** Keeps a cell, the points {@code points[from..to)}, until its type is read. */
    void add(InputLocator source, long[] points, int from, int to) {
        cells.add(Arrays.copyOfRange(points, from, to));
    }

    /** Reads the section CELL_TYPES and adds the cells to the surface. */
    void readTypes(ByteCursor cursor) {
        int count = cursor.count("the number of types");
        cursor.lineOrNull();
        if (count != cells.size()) {
            throw cursor.badInput("found " + count + " types of cells, expected one for each of " + cells.size());
        }
        cursor.requireValues(count, ScalarType.INT32, count + " types");
        for (long[] cell : cells) {
            addToSurface(cursor, cell, cursor.readLong(ScalarType.INT32, "the type of a cell"));
        }
        cells.clear();
    }

    private void addToSurface(ByteCursor cursor, long[] cell, long type) {
        if (type >= 0 && type <= LAST_LINE) {
            return;
        }
        if (type == STRIP) {
            soup.strip(cursor, cell, 0, cell.length);
        } else if (type == PIXEL && cell.length == 4) {
            // A pixel lists its corners row by row.
            soup.polygon(cursor, new long[] {cell[0], cell[1], cell[3], cell[2]}, 0, 4);
        } else if (type == TRIANGLE || type == POLYGON || type == QUAD) {
            soup.polygon(cursor, cell, 0, cell.length);
        } else {
            throw cursor.badInput("found a cell of type " + type + " with " + cell.length
                    + " points, expected triangles, quads or polygons (extract the surface of a volume mesh first)");
        }
    }

    /** @throws org.phrenic.file.BadInputException if cells are left without types */
    void checkTyped(ByteCursor cursor) {
        if (!cells.isEmpty()) {
            throw cursor.badInput("found " + cells.size() + " cells without types, expected CELL_TYPES");
        }
    }
}
