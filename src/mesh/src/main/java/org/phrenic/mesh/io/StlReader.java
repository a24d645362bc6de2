package org.phrenic.mesh.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;

/**
 * Reader of STL, text or binary (3D Systems, "StereoLithography Interface Specification", 1989). A file is binary if
 * its length matches the triangle count at byte 80. The first word is not used, because some programs begin the 80-byte
 * header of a binary file with "solid". Corners with equal coordinates become one vertex. Normals follow from the
 * corner order and are not read.
 */
final class StlReader {
    private static final int HEADER_BYTES = 80;
    private static final int TRIANGLE_BYTES = 50;
    private static final int PEEKED_BYTES = 1024;

    private final ByteCursor cursor;
    private final PolygonSoup soup = new PolygonSoup();
    private int corners;

    private StlReader(String file, byte[] bytes) {
        this.cursor = new ByteCursor(file, bytes);
    }

    static TriangleMesh read(String file, byte[] bytes) {
        StlReader reader = new StlReader(file, bytes);
        if (!isBinary(bytes) && isText(bytes)) {
            reader.readText();
        } else {
            reader.readBinary();
        }
        // STL repeats the coordinates of a vertex in every triangle, so equal coordinates are one vertex.
        return MeshRepair.weld(reader.soup.toMesh(file), 0).mesh();
    }

    private static boolean isBinary(byte[] bytes) {
        if (bytes.length < HEADER_BYTES + 4) {
            return false;
        }
        long count = ScalarType.UINT32.readLong(ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN), HEADER_BYTES);
        return bytes.length == HEADER_BYTES + 4 + TRIANGLE_BYTES * count;
    }

    private static boolean isText(byte[] bytes) {
        int peeked = Math.min(bytes.length, PEEKED_BYTES);
        for (int i = 0; i < peeked; i++) {
            if (bytes[i] == 0) {
                return false;
            }
        }
        String begin = new String(bytes, 0, peeked, StandardCharsets.ISO_8859_1);
        return begin.stripLeading().toLowerCase(Locale.ROOT).startsWith("solid");
    }

    private void readBinary() {
        cursor.binary(ByteOrder.LITTLE_ENDIAN);
        cursor.skip(HEADER_BYTES, "the header of a binary STL file (a text one begins with 'solid')");
        long count = cursor.readLong(ScalarType.UINT32, "the number of triangles");
        long promised = TRIANGLE_BYTES * count;
        if (cursor.remaining() != promised) {
            throw cursor.badInput("found " + count + " triangles promised and " + cursor.remaining()
                    + " bytes after that, expected " + promised + " bytes");
        }
        double[] corner = new double[3];
        for (long t = 0; t < count; t++) {
            cursor.skip(12, "a normal");
            for (int c = 0; c < 3; c++) {
                for (int axis = 0; axis < 3; axis++) {
                    corner[axis] = cursor.readDouble(ScalarType.FLOAT32, "a coordinate");
                }
                soup.vertex(cursor, corner[0], corner[1], corner[2]);
            }
            closeTriangle();
            cursor.skip(2, "the attribute of a triangle");
        }
    }

    private void readText() {
        expect("solid");
        cursor.lineOrNull();
        String word = cursor.word("'facet' or 'endsolid'");
        while (word != null) {
            switch (word.toLowerCase(Locale.ROOT)) {
                case "facet" -> readFacet();
                case "endsolid" -> {
                    cursor.lineOrNull();
                    if (!nextSolid()) {
                        return;
                    }
                }
                default -> throw cursor.badInput("found " + Numbers.quote(word) + ", expected 'facet' or 'endsolid'");
            }
            word = cursor.word("'facet' or 'endsolid'");
        }
    }

    private boolean nextSolid() {
        String word = cursor.wordOrNull();
        if (word == null) {
            return false;
        }
        if (!word.equalsIgnoreCase("solid")) {
            throw cursor.badInput("found " + Numbers.quote(word) + ", expected 'solid' or the end of the file");
        }
        cursor.lineOrNull();
        return true;
    }

    private void readFacet() {
        expect("normal");
        for (int axis = 0; axis < 3; axis++) {
            cursor.word("a component of the normal");
        }
        expect("outer");
        expect("loop");
        for (int c = 0; c < 3; c++) {
            expect("vertex");
            double x = cursor.number("a coordinate");
            double y = cursor.number("a coordinate");
            double z = cursor.number("a coordinate");
            soup.vertex(cursor, x, y, z);
        }
        closeTriangle();
        expect("endloop");
        expect("endfacet");
    }

    private void closeTriangle() {
        soup.triangle(cursor, corners, corners + 1, corners + 2);
        corners += 3;
    }

    private void expect(String keyword) {
        String word = cursor.word("'" + keyword + "'");
        if (!word.equalsIgnoreCase(keyword)) {
            throw cursor.badInput("found " + Numbers.quote(word) + ", expected '" + keyword + "'");
        }
    }
}
