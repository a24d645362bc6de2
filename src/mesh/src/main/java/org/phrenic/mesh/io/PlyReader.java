package org.phrenic.mesh.io;

import java.util.List;
import org.phrenic.file.ByteCursor;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.PlyHeader.Element;
import org.phrenic.mesh.io.PlyHeader.Property;

/**
 * Reader of PLY, text or binary in either byte order. It reads x, y, z of {@code vertex} and the index list of
 * {@code face}; other data is skipped.
 */
record PlyReader(ByteCursor cursor, PolygonSoup soup) {
    private static final int ABSENT = -1;

    static TriangleMesh read(String file, byte[] bytes) {
        PlyReader reader = new PlyReader(ByteCursor.ofText(file, bytes), new PolygonSoup());
        reader.readElements();
        return reader.soup.toMesh(file);
    }

    private void readElements() {
        PlyHeader header = PlyHeader.read(cursor);
        for (Element element : header.elements()) {
            long smallest = element.count() * element.smallestRow(cursor.isBinary());
            // The last word of a text file needs no separator after it.
            cursor.require(
                    cursor.isBinary() ? smallest : Math.max(0, smallest - 1),
                    element.count() + " elements '" + element.name() + "'");
            switch (element.name()) {
                case "vertex" -> readVertices(element);
                case "face" -> readFaces(element);
                default -> skipRows(element);
            }
        }
        String rest = cursor.wordOrNull();
        if (rest != null) {
            throw cursor.badInput("found more content, expected the end of the file after the last element");
        }
    }

    private void readVertices(Element element) {
        List<Property> properties = element.properties();
        int[] axes = {find(element, "x"), find(element, "y"), find(element, "z")};
        double[] row = new double[properties.size()];
        for (int v = 0; v < element.count(); v++) {
            for (int p = 0; p < row.length; p++) {
                Property property = properties.get(p);
                boolean wanted = p == axes[0] || p == axes[1] || p == axes[2];
                if (wanted) {
                    row[p] = cursor.readDouble(property.type(), property.name());
                } else {
                    skip(property);
                }
            }
            soup.vertex(cursor, row[axes[0]], row[axes[1]], row[axes[2]]);
        }
    }

    private int find(Element element, String name) {
        for (int p = 0; p < element.properties().size(); p++) {
            Property property = element.properties().get(p);
            if (property.name().equals(name) && !property.isList()) {
                return p;
            }
        }
        throw cursor.badInput("found element 'vertex' without property '" + name + "', expected x, y and z");
    }

    private void readFaces(Element element) {
        int list = ABSENT;
        for (int p = 0; p < element.properties().size(); p++) {
            Property property = element.properties().get(p);
            boolean named =
                    property.name().equals("vertex_indices") || property.name().equals("vertex_index");
            if (named && property.isList() && property.type().isInteger()) {
                list = p;
            }
        }
        if (list == ABSENT) {
            throw cursor.badInput(
                    "found element 'face' without a list of whole numbers 'vertex_indices', expected one");
        }
        for (int f = 0; f < element.count(); f++) {
            for (int p = 0; p < element.properties().size(); p++) {
                Property property = element.properties().get(p);
                if (p == list) {
                    long corners = listLength(property);
                    for (long c = 0; c < corners; c++) {
                        soup.corner(cursor, cursor.readLong(property.type(), "a vertex index"));
                    }
                    soup.closePolygon(cursor);
                } else {
                    skip(property);
                }
            }
        }
    }

    private void skipRows(Element element) {
        if (element.properties().isEmpty()) {
            return;
        }
        for (int row = 0; row < element.count(); row++) {
            element.properties().forEach(this::skip);
        }
    }

    private void skip(Property property) {
        long count = property.isList() ? listLength(property) : 1;
        if (cursor.isBinary()) {
            cursor.skip(count * property.type().size(), property.valueText());
        } else {
            for (long i = 0; i < count; i++) {
                cursor.word(property.valueText());
            }
        }
    }

    private long listLength(Property property) {
        long count = cursor.readLong(property.listCount(), property.lengthText());
        if (count < 0 || count > Integer.MAX_VALUE) {
            throw cursor.badInput("found list length " + count + ", expected 0 to " + Integer.MAX_VALUE);
        }
        cursor.requireValues(count, property.type(), property.listText());
        return count;
    }
}
