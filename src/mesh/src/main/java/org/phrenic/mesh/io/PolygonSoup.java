package org.phrenic.mesh.io;

import java.util.Arrays;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputLocator;
import org.phrenic.mesh.TriangleMesh;

/**
 * Vertices and polygons as a reader meets them; in the end a triangle mesh. Refuses coordinates that are no finite
 * numbers, polygons of fewer than three corners, and corners that name no vertex. A polygon may come before its
 * vertices.
 */
final class PolygonSoup {
    private double[] positions = new double[192];
    private int coordinateCount;
    private int[] corners = new int[192];
    private int cornerCount;
    private int[] polygonEnds = new int[64];
    private int polygonCount;
    private long highestCorner = -1;
    private long highestPlace;
    private InputLocator highestSource;

    int vertexCount() {
        return coordinateCount / 3;
    }

    void vertex(InputLocator source, double x, double y, double z) {
        if (!(Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z))) {
            throw source.badInput("found vertex (" + x + ", " + y + ", " + z + "), expected three finite coordinates");
        }
        if (coordinateCount + 3 > positions.length) {
            positions = Arrays.copyOf(positions, grown(positions.length));
        }
        positions[coordinateCount++] = x;
        positions[coordinateCount++] = y;
        positions[coordinateCount++] = z;
    }

    /** One more corner of the polygon that {@link #closePolygon} ends; {@code vertex} counts from 0. */
    void corner(InputLocator source, long vertex) {
        if (vertex < 0 || vertex > Integer.MAX_VALUE) {
            throw source.badInput("found vertex index " + vertex + ", expected 0 or more");
        }
        if (vertex >= vertexCount() && vertex > highestCorner) {
            highestCorner = vertex;
            highestPlace = source.location();
            highestSource = source;
        }
        if (cornerCount == corners.length) {
            corners = Arrays.copyOf(corners, grown(corners.length));
        }
        corners[cornerCount++] = (int) vertex;
    }

    void closePolygon(InputLocator source) {
        int begin = polygonCount == 0 ? 0 : polygonEnds[polygonCount - 1];
        if (cornerCount - begin < 3) {
            throw source.badInput("found a face of " + (cornerCount - begin) + " corners, expected 3 or more");
        }
        if (polygonCount == polygonEnds.length) {
            polygonEnds = Arrays.copyOf(polygonEnds, grown(polygonEnds.length));
        }
        polygonEnds[polygonCount++] = cornerCount;
    }

    /** Triangle {@code a b c}. */
    void triangle(InputLocator source, long a, long b, long c) {
        corner(source, a);
        corner(source, b);
        corner(source, c);
        closePolygon(source);
    }

    /** The mesh, polygons cut into triangles in the order they came. */
    TriangleMesh toMesh(String file) {
        if (highestCorner >= vertexCount()) {
            throw highestSource.badInput(
                    highestPlace,
                    "found vertex index " + highestCorner + " (counted from 0), expected one below the " + vertexCount()
                            + " vertices of the file");
        }
        if (polygonCount == 0) {
            throw new BadInputException(file + ": found no triangles, expected a surface of at least one");
        }
        double[] vertices = Arrays.copyOf(positions, coordinateCount);
        int[] triangles = new int[3 * (cornerCount - 2 * polygonCount)];
        int filled = 0;
        int begin = 0;
        for (int p = 0; p < polygonCount; p++) {
            filled = PolygonTriangulator.triangulate(vertices, corners, begin, polygonEnds[p], triangles, filled);
            begin = polygonEnds[p];
        }
        return new TriangleMesh(vertices, triangles);
    }

    private static int grown(int length) {
        return (int) Math.min(2L * length, Integer.MAX_VALUE - 8);
    }
}
