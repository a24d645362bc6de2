package org.phrenic.mesh.io;

import java.nio.ByteOrder;
import java.util.Locale;
import org.phrenic.file.ByteCursor;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.TriangleMesh;

/**
 * Reader of legacy VTK files with POLYDATA or the surface cells of an UNSTRUCTURED_GRID, text or binary (big endian),
 * as specified in "VTK File Formats" (docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html). It reads
 * POINTS, POLYGONS and TRIANGLE_STRIPS, or CELLS with CELL_TYPES. Vertices, lines, fields, metadata, point data and
 * cell data are ignored.
 */
final class VtkReader {
    private static final String MAGIC = "# vtk DataFile Version ";

    private final ByteCursor cursor;
    private final PolygonSoup soup = new PolygonSoup();
    private final VtkGridCells grid = new VtkGridCells(soup);
    private boolean pointsSeen;

    private VtkReader(String file, byte[] bytes) {
        this.cursor = ByteCursor.ofText(file, bytes);
    }

    static TriangleMesh read(String file, byte[] bytes) {
        VtkReader reader = new VtkReader(file, bytes);
        reader.readSections(reader.readHeader());
        return reader.soup.toMesh(file);
    }

    private VtkCells readHeader() {
        String magic = cursor.line("'" + MAGIC + "'");
        if (!magic.toLowerCase(Locale.ROOT).startsWith(MAGIC.toLowerCase(Locale.ROOT))) {
            throw cursor.unexpected(magic, "'" + MAGIC + "x.y'");
        }
        double version = Numbers.parse(magic.substring(MAGIC.length()).trim())
                .orElseThrow(() -> cursor.unexpected(magic, "a version number"));
        cursor.line("a title");
        String encoding = cursor.word("ASCII or BINARY");
        switch (encoding.toUpperCase(Locale.ROOT)) {
            case "ASCII" -> cursor.lineOrNull();
            case "BINARY" -> {
                cursor.lineOrNull();
                cursor.binary(ByteOrder.BIG_ENDIAN);
            }
            default -> throw cursor.unexpected(encoding, "ASCII or BINARY");
        }
        return new VtkCells(cursor, version >= 5.1);
    }

    private void readSections(VtkCells cells) {
        boolean datasetSeen = false;
        for (String word = cursor.wordOrNull(); word != null; word = cursor.wordOrNull()) {
            String keyword = word.toUpperCase(Locale.ROOT);
            if (!datasetSeen && !keyword.equals("DATASET") && !keyword.equals("FIELD") && !keyword.equals("METADATA")) {
                throw cursor.unexpected(word, "DATASET");
            }
            switch (keyword) {
                case "DATASET" -> {
                    String kind = cursor.word("POLYDATA");
                    if (!kind.equalsIgnoreCase("POLYDATA") && !kind.equalsIgnoreCase("UNSTRUCTURED_GRID")) {
                        throw cursor.badInput(
                                "found a dataset " + Numbers.quote(kind) + ", expected POLYDATA or UNSTRUCTURED_GRID");
                    }
                    datasetSeen = true;
                }
                case "POINTS" -> readPoints();
                case "POLYGONS" -> cells.read(soup::polygon);
                case "TRIANGLE_STRIPS" -> cells.read(soup::strip);
                case "CELLS" -> cells.read(grid::add);
                case "CELL_TYPES" -> grid.readTypes(cursor);
                case "VERTICES", "LINES" ->
                    cells.read((source, points, from, to) -> {
                        // Not part of the surface.
                    });
                case "FIELD" -> skipField(cursor);
                case "METADATA" -> skipMetadata(cursor);
                case "POINT_DATA", "CELL_DATA" -> {
                    grid.checkTyped(cursor);
                    return;
                }
                default ->
                    throw cursor.unexpected(word, "POINTS, POLYGONS, TRIANGLE_STRIPS or another section of POLYDATA");
            }
        }
        grid.checkTyped(cursor);
        if (!pointsSeen) {
            throw cursor.badInput("found the end of the file, expected DATASET POLYDATA with POINTS");
        }
    }

    private void readPoints() {
        if (pointsSeen) {
            throw cursor.badInput("found POINTS a second time, expected it once");
        }
        pointsSeen = true;
        int count = cursor.count("the number of points");
        ScalarType type = type(cursor, cursor.word("the type of the points"));
        cursor.lineOrNull();
        cursor.requireValues(3L * count, type, count + " points");
        for (int i = 0; i < count; i++) {
            soup.vertex(cursor, type);
        }
    }

    static ScalarType type(ByteCursor cursor, String name) {
        return switch (name.toLowerCase(Locale.ROOT)) {
            case "char", "signed_char", "vtktypeint8" -> ScalarType.INT8;
            case "unsigned_char", "vtktypeuint8" -> ScalarType.UINT8;
            case "short", "vtktypeint16" -> ScalarType.INT16;
            case "unsigned_short", "vtktypeuint16" -> ScalarType.UINT16;
            // VTK writes vtkIdType as a 32-bit number to legacy files, whatever its size in memory.
            case "int", "vtkidtype", "vtktypeint32" -> ScalarType.INT32;
            case "unsigned_int", "vtktypeuint32" -> ScalarType.UINT32;
            case "long", "vtktypeint64" -> ScalarType.INT64;
            case "unsigned_long", "vtktypeuint64" -> ScalarType.UINT64;
            case "float" -> ScalarType.FLOAT32;
            case "double" -> ScalarType.FLOAT64;
            default ->
                throw cursor.badInput("found type " + Numbers.quote(name) + ", expected float, double, int or alike");
        };
    }

    /** Skips the arrays of a field; the cursor is after the word FIELD. */
    private static void skipField(ByteCursor cursor) {
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
                default -> skipNumbers(cursor, type(cursor, type), values, what);
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
     * Skips strings. In a text file a string is a line. In a binary file it follows its length, whose size in bytes is
     * encoded in the first two bits.
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

    /** Skips metadata, which ends with an empty line. */
    private static void skipMetadata(ByteCursor cursor) {
        cursor.lineOrNull();
        String line = cursor.lineOrNull();
        while (line != null && !line.isBlank()) {
            line = cursor.lineOrNull();
        }
    }
}
