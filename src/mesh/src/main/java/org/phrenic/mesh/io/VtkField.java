package org.phrenic.mesh.io;

import org.phrenic.file.ByteCursor;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;

/**
 * FIELD and METADATA of a legacy VTK file: no part of the surface, but they stand before it and must be stepped over.
 */
final class VtkField {
    private VtkField() {}

    /** Steps over the arrays of a field; the cursor stands after the word FIELD. */
    static void skip(ByteCursor cursor) {
        cursor.word("the name of the field");
        int arrays = cursor.count("the number of arrays in the field");
        for (int a = 0; a < arrays; a++) {
            String name = cursor.word("the name of an array");
            if (name.equals("METADATA")) {
                skipMetadata(cursor);
                name = cursor.word("the name of an array");
            }
            String what = "array " + Numbers.quote(name);
            long values = (long) cursor.count("the number of components of " + what)
                    * cursor.count("the number of tuples of " + what);
            String type = cursor.word("the type of " + what);
            cursor.lineOrNull();
            switch (type) {
                case "string", "utf8_string" -> skipTexts(cursor, values, what);
                case "bit" ->
                    skipNumbers(cursor, ScalarType.UINT8, cursor.isBinary() ? (values + 7) / 8 : values, what);
                default -> skipNumbers(cursor, VtkReader.type(cursor, type), values, what);
            }
        }
    }

    private static void skipNumbers(ByteCursor cursor, ScalarType type, long values, String what) {
        cursor.requireValues(values, type, what);
        if (cursor.isBinary()) {
            cursor.skip(values * type.size(), what);
            return;
        }
        for (long v = 0; v < values; v++) {
            cursor.word("a value of " + what);
        }
    }

    /**
     * A text is a line; in a binary file it follows its length, which takes as many bytes as its first two bits tell.
     */
    private static void skipTexts(ByteCursor cursor, long values, String what) {
        cursor.require(values, what);
        for (long v = 0; v < values; v++) {
            if (cursor.isBinary()) {
                long first = cursor.readLong(ScalarType.UINT8, what);
                int more = new int[] {7, 3, 1, 0}[(int) (first >> 6)];
                long length = first & 0x3F;
                for (int i = 0; i < more; i++) {
                    length = length << 8 | cursor.readLong(ScalarType.UINT8, what);
                }
                cursor.skip(length, what);
            } else {
                cursor.line("a text of " + what);
            }
        }
    }

    /** Metadata ends with an empty line. */
    static void skipMetadata(ByteCursor cursor) {
        cursor.lineOrNull();
        String line = cursor.lineOrNull();
        while (line != null && !line.isBlank()) {
            line = cursor.lineOrNull();
        }
    }
}
