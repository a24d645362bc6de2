package org.phrenic.mesh.io;

import java.util.Arrays;
import java.util.StringTokenizer;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.TriangleMesh;

/**
 * Reader of Wavefront OBJ: vertices ({@code v}) and polygons ({@code f} with v, v/vt, v//vn or v/vt/vn). Negative
 * indices count back from the latest vertex, and a backslash joins lines, but not within a comment. Groups, materials,
 * normals, textures, points and lines are ignored. Coordinates are read in double precision. All vertices keep their
 * order and index, used or not.
 */
record ObjReader(ByteCursor cursor, PolygonSoup soup) {

    static TriangleMesh read(String file, byte[] bytes) {
        ObjReader reader = new ObjReader(ByteCursor.ofText(file, bytes), new PolygonSoup());
        reader.readLines();
        return reader.soup.toMesh(file);
    }

    private void readLines() {
        for (String line = cursor.lineOrNull(); line != null; line = cursor.lineOrNull()) {
            String statement = withoutComment(line);
            while (statement.endsWith("\\")) {
                statement = statement.substring(0, statement.length() - 1) + " "
                        + withoutComment(cursor.line("the rest of a line that ends with a backslash"));
            }
            String[] words = words(statement);
            switch (words.length == 0 ? "" : words[0]) {
                case "v" -> readVertex(words);
                case "f", "fo" -> readFace(words);
                default -> {
                    // Not part of the surface.
                }
            }
        }
    }

    private static String withoutComment(String line) {
        int comment = line.indexOf('#');
        return comment < 0 ? line : line.substring(0, comment);
    }

    private static String[] words(String statement) {
        StringTokenizer tokens = new StringTokenizer(statement);
        String[] words = new String[tokens.countTokens()];
        Arrays.setAll(words, i -> tokens.nextToken());
        return words;
    }

    private void readVertex(String[] words) {
        if (words.length < 4) {
            throw cursor.badInput("found a vertex of " + (words.length - 1) + " coordinates, expected 3");
        }
        soup.vertex(cursor, coordinate(words[1]), coordinate(words[2]), coordinate(words[3]));
    }

    private double coordinate(String word) {
        return Numbers.parse(word).orElseThrow(() -> cursor.unexpected(word, "a coordinate as a finite number"));
    }

    private void readFace(String[] words) {
        for (int i = 1; i < words.length; i++) {
            int slash = words[i].indexOf('/');
            long index = index(words[i], slash < 0 ? words[i] : words[i].substring(0, slash));
            long vertex = index > 0 ? index - 1 : soup.vertexCount() + index;
            if (vertex < 0) {
                throw cursor.badInput("found vertex index " + index + " after " + soup.vertexCount()
                        + " vertices, expected -" + soup.vertexCount() + " or nearer to zero");
            }
            for (int from = slash; from >= 0; ) {
                int next = words[i].indexOf('/', from + 1);
                String part = words[i].substring(from + 1, next < 0 ? words[i].length() : next);
                if (!part.isEmpty()) {
                    index(words[i], part);
                }
                from = next;
            }
            soup.corner(cursor, vertex);
        }
        soup.closePolygon(cursor);
    }

    private long index(String corner, String digits) {
        long index =
                Numbers.parseWhole(digits, Integer.MIN_VALUE, Integer.MAX_VALUE).orElse(0);
        if (index != 0) {
            return index;
        }
        throw cursor.badInput("found face corner " + Numbers.quote(corner)
                + ", expected vertex indices as v, v/vt, v//vn or v/vt/vn, counted from 1 or backwards from -1");
    }
}
