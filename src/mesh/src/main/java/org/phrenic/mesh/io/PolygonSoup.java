package org.phrenic.mesh.io;

import org.phrenic.file.BadInputException;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.InputLocator;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;

/**
 * Vertices and polygons collected by a reader, and the triangle mesh made from them. Rejects coordinates that are not
 * finite, polygons of fewer than three corners, and vertex indices out of range. A polygon may precede its vertices.
 */
final class PolygonSoup {
    private final DoubleList positions = new DoubleList();
    private final IntList corners = new IntList();
    private final IntList polygonEnds = new IntList();
    private long highestCorner = -1;
    private long highestPlace;
    private InputLocator highestSource;

    int vertexCount() {
        return positions.size() / 3;
    }

    void vertex(InputLocator source, double x, double y, double z) {
        if (!(Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z))) {
            throw source.badInput("found vertex (" + x + ", " + y + ", " + z + "), expected three finite coordinates");
        }
        positions.add(x, y, z);
    }

    /** Adds the vertex whose coordinates are the next three values. */
    void vertex(ByteCursor cursor, ScalarType type) {
        String what = "a coordinate";
        vertex(cursor, cursor.readDouble(type, what), cursor.readDouble(type, what), cursor.readDouble(type, what));
    }

    /** Adds a corner to the polygon that {@link #closePolygon} ends; {@code vertex} counts from 0. */
    void corner(InputLocator source, long vertex) {
        if (vertex < 0 || vertex > Integer.MAX_VALUE) {
            throw source.badInput("found vertex index " + vertex + ", expected 0 or more");
        }
        if (vertex >= vertexCount() && vertex > highestCorner) {
            highestCorner = vertex;
            highestPlace = source.location();
            highestSource = source;
        }
        corners.add((int) vertex);
    }

    void closePolygon(InputLocator source) {
        int size = corners.size() - polygonStart(polygonEnds.size());
        if (size < 3) {
            throw source.badInput("found a face of " + size + " corners, expected 3 or more");
        }
        polygonEnds.add(corners.size());
    }

    private int polygonStart(int polygon) {
        return polygon == 0 ? 0 : polygonEnds.get(polygon - 1);
    }

    /** Adds triangle {@code a b c}. */
    void triangle(InputLocator source, long a, long b, long c) {
        corner(source, a);
        corner(source, b);
        corner(source, c);
        closePolygon(source);
    }

    /** Adds the polygon {@code points[from..to)}. */
    void polygon(InputLocator source, long[] points, int from, int to) {
        for (int i = from; i < to; i++) {
            corner(source, points[i]);
        }
        closePolygon(source);
    }

    /**
     * Adds the triangle strip {@code points[from..to)}. Every second triangle is reversed, so that all have the same
     * orientation.
     */
    void strip(InputLocator source, long[] points, int from, int to) {
        if (to - from < 3) {
            throw source.badInput("found a strip of " + (to - from) + " points, expected 3 or more");
        }
        for (int i = from; i + 2 < to; i++) {
            int odd = (i - from) % 2;
            triangle(source, points[i + odd], points[i + 1 - odd], points[i + 2]);
        }
    }

    /** The mesh with all polygons triangulated, in the order they were added. */
    TriangleMesh toMesh(String file) {
        if (highestCorner >= vertexCount()) {
            throw highestSource.badInput(
                    highestPlace,
                    "found vertex index " + highestCorner + " (counted from 0), expected one below the " + vertexCount()
                            + " vertices of the file");
        }
        if (polygonEnds.isEmpty()) {
            throw new BadInputException(file + ": found no triangles, expected a surface of at least one");
        }
        double[] vertices = positions.toArray();
        int[] all = corners.toArray();
        int[] triangles = new int[3 * (all.length - 2 * polygonEnds.size())];
        int filled = 0;
        for (int p = 0; p < polygonEnds.size(); p++) {
            filled = PolygonTriangulator.triangulate(
                    vertices, all, polygonStart(p), polygonEnds.get(p), triangles, filled);
        }
        return new TriangleMesh(vertices, triangles);
    }
}
