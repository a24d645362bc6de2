package org.phrenic.mesh.io;

import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;

/**
 * The header of a PLY file (Turk 1994, "The PLY polygon file format"): the elements with their counts and properties.
 * Reading it leaves the cursor at the first element, in the byte order of the file.
 */
record PlyHeader(List<Element> elements) {
    /**
     * A property of an element. {@code listCount} is the type of the list length, null for a single value. The last
     * three components are descriptions for error messages, created once instead of per row.
     */
    record Property(
            String name, ScalarType listCount, ScalarType type, String valueText, String lengthText, String listText) {
        Property(String name, ScalarType listCount, ScalarType type) {
            this(
                    name,
                    listCount,
                    type,
                    "property '" + name + "'",
                    "the length of list '" + name + "'",
                    "list '" + name + "'");
        }

        boolean isList() {
            return listCount != null;
        }
    }

    /** An element type with {@code count} rows of {@code properties}. */
    record Element(String name, int count, List<Property> properties) {
        /** Least number of bytes per row. */
        long smallestRow(boolean binary) {
            return properties.stream()
                    .map(property -> property.isList() ? property.listCount() : property.type())
                    .mapToLong(first -> binary ? first.size() : 2)
                    .sum();
        }
    }

    static PlyHeader read(ByteCursor cursor) {
        if (!cursor.line("'ply'").strip().equals("ply")) {
            throw cursor.badInput("found another first line, expected 'ply'");
        }
        List<Element> elements = new ArrayList<>();
        ByteOrder order = null;
        boolean formatSeen = false;
        while (true) {
            String line = cursor.line("'end_header'");
            String[] words = line.trim().split("\\s+", -1);
            switch (words[0]) {
                case "comment", "obj_info", "" -> {
                    // Not part of the mesh.
                }
                case "format" -> {
                    order = order(cursor, words);
                    formatSeen = true;
                }
                case "element" -> elements.add(element(cursor, words));
                case "property" -> {
                    if (elements.isEmpty()) {
                        throw cursor.badInput("found a property, expected an element before it");
                    }
                    elements.get(elements.size() - 1).properties().add(property(cursor, words));
                }
                case "end_header" -> {
                    if (!formatSeen) {
                        throw cursor.badInput("found no format line, expected 'format ascii 1.0' or a binary one");
                    }
                    if (order != null) {
                        cursor.binary(order);
                    }
                    return new PlyHeader(elements);
                }
                default -> throw cursor.unexpected(line, "element, property or end_header");
            }
        }
    }

    private static ByteOrder order(ByteCursor cursor, String[] words) {
        String format = words.length > 1 ? words[1] : "";
        return switch (format) {
            case "ascii" -> null;
            case "binary_little_endian" -> ByteOrder.LITTLE_ENDIAN;
            case "binary_big_endian" -> ByteOrder.BIG_ENDIAN;
            default ->
                throw cursor.badInput("found format " + Numbers.quote(format)
                        + ", expected ascii, binary_little_endian or binary_big_endian");
        };
    }

    private static Element element(ByteCursor cursor, String[] words) {
        if (words.length != 3) {
            throw cursor.badInput(
                    "found " + (words.length - 1) + " words after 'element', expected a name and a count");
        }
        String expected = "the number of elements '" + words[1] + "' from 0 to " + Integer.MAX_VALUE;
        long count = Numbers.parseWhole(words[2], 0, Integer.MAX_VALUE)
                .orElseThrow(() -> cursor.unexpected(words[2], expected));
        return new Element(words[1], (int) count, new ArrayList<>());
    }

    private static Property property(ByteCursor cursor, String[] words) {
        if (words.length == 3) {
            return new Property(words[2], null, type(cursor, words[1]));
        }
        if (words.length == 5 && words[1].equals("list")) {
            ScalarType count = type(cursor, words[2]);
            if (!count.isInteger()) {
                throw cursor.unexpected(words[2], "a whole-number type for a length");
            }
            return new Property(words[4], count, type(cursor, words[3]));
        }
        throw cursor.unexpected(String.join(" ", words), "'property TYPE NAME' or 'property list TYPE TYPE NAME'");
    }

    private static ScalarType type(ByteCursor cursor, String name) {
        return switch (name) {
            case "char", "int8" -> ScalarType.INT8;
            case "uchar", "uint8" -> ScalarType.UINT8;
            case "short", "int16" -> ScalarType.INT16;
            case "ushort", "uint16" -> ScalarType.UINT16;
            case "int", "int32" -> ScalarType.INT32;
            case "uint", "uint32" -> ScalarType.UINT32;
            case "int64", "long" -> ScalarType.INT64;
            case "uint64", "ulong" -> ScalarType.UINT64;
            case "float", "float32" -> ScalarType.FLOAT32;
            case "double", "float64" -> ScalarType.FLOAT64;
            default ->
                throw cursor.badInput(
                        "found property type " + Numbers.quote(name) + ", expected char to double or int8 to float64");
        };
    }
}
