package org.phrenic.mesh.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;

/**
 * Reader of STL, text or binary (3D Systems, "StereoLithography Interface Specification", 1989). A file is binary if
 * its length matches the triangle count at byte 80. The first word is not used, because some programs begin the 80-byte
 * header of a binary file with "solid". Corners with equal coordinates become one vertex. Normals follow from the
 * corner order and are not read.
 */
record StlReader(ByteCursor cursor, PolygonSoup soup) {
    private static final int HEADER_BYTES = 80;
    private static final int TRIANGLE_BYTES = 50;
    private static final int PEEKED_BYTES = 1024;

    static TriangleMesh read(String file, byte[] bytes) {
        boolean isText = !isBinary(bytes) && isText(bytes);
        ByteCursor cursor = isText ? ByteCursor.ofText(file, bytes) : new ByteCursor(file, bytes);
        StlReader reader = new StlReader(cursor, new PolygonSoup());
        if (isText) {
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
        int start = ByteCursor.textStart(bytes);
        String begin = new String(bytes, start, peeked - start, StandardCharsets.ISO_8859_1);
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
        for (long t = 0; t < count; t++) {
            cursor.skip(12, "a normal");
            for (int c = 0; c < 3; c++) {
                soup.vertex(cursor, ScalarType.FLOAT32);
            }
            closeTriangle();
            cursor.skip(2, "the attribute of a triangle");
        }
    }

    private void readText() {
        for (String word = cursor.word("'solid'"); word != null; word = cursor.wordOrNull()) {
            if (!word.equalsIgnoreCase("solid")) {
                throw cursor.unexpected(word, "'solid' or the end of the file");
            }
            cursor.lineOrNull();
            String expected = "'facet' or 'endsolid'";
            for (String next = cursor.word(expected);
                    !next.equalsIgnoreCase("endsolid");
                    next = cursor.word(expected)) {
                if (!next.equalsIgnoreCase("facet")) {
                    throw cursor.unexpected(next, expected);
                }
                readFacet();
            }
            cursor.lineOrNull();
        }
    }

    private void readFacet() {
        cursor.expect("normal");
        for (int axis = 0; axis < 3; axis++) {
            cursor.word("a component of the normal");
        }
        cursor.expect("outer");
        cursor.expect("loop");
        for (int c = 0; c < 3; c++) {
            cursor.expect("vertex");
            soup.vertex(cursor, ScalarType.FLOAT32);
        }
        closeTriangle();
        cursor.expect("endloop");
        cursor.expect("endfacet");
    }

    private void closeTriangle() {
        int corners = soup.vertexCount();
        soup.triangle(cursor, corners - 3, corners - 2, corners - 1);
    }
}
