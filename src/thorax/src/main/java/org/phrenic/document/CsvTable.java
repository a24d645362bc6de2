package org.phrenic.document;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * A table read from CSV (RFC 4180, UTF-8, with or without byte order mark) whose first line has the column names. The
 * delimiter is a comma or a semicolon, as in the header. With semicolons, numbers may have a decimal comma.
 */
public final class CsvTable {
    private final String file;
    private final boolean decimalComma;
    private final Map<String, Integer> columns;
    private final List<String[]> rows;
    private final List<Long> lines;

    private CsvTable(
            String file, boolean decimalComma, Map<String, Integer> columns, List<String[]> rows, List<Long> lines) {
        this.file = file;
        this.decimalComma = decimalComma;
        this.columns = columns;
        this.rows = rows;
        this.lines = lines;
    }

    /**
     * Reads {@code file}. Markups of 3D Slicer ({@code .mrk.json}, {@code .fcsv}) are a table of name, x_mm, y_mm, z_mm
     * in LPS.
     *
     * @throws BadInputException if it cannot be read, a column name is missing or repeated, or a row and the header
     *     differ in length
     */
    public static CsvTable read(Path file) {
        if (MarkupPoints.isMarkups(file)) {
            return MarkupPoints.read(file);
        }
        if (FiducialPoints.isFiducials(file)) {
            return FiducialPoints.read(file);
        }
        return parse(file.toString(), TextFile.read(file, "a table in UTF-8"));
    }

    /** A table of cells with the line of each row. */
    static CsvTable of(String file, List<String> names, List<String[]> rows, List<Long> lines) {
        Map<String, Integer> columns = new LinkedHashMap<>();
        names.forEach(name -> columns.put(name, columns.size()));
        return new CsvTable(file, false, columns, rows, lines);
    }

    /**
     * Parses {@code text}.
     *
     * @param name name for error messages
     */
    public static CsvTable parse(String name, String text) {
        return parse(name, text, null);
    }

    /** Parses {@code text} and ignores lines that begin with {@code comment}; null for no comments. */
    public static CsvTable parse(String name, String text, Character comment) {
        String content = text.startsWith("\uFEFF") ? text.substring(1) : text;
        char delimiter = comment == null ? delimiter(content) : ',';
        Map<String, Integer> columns = new LinkedHashMap<>();
        List<String[]> rows = new ArrayList<>();
        List<Long> lines = new ArrayList<>();
        forEachRecord(name, content, delimiter, comment, (line, cells) -> {
            if (columns.isEmpty()) {
                readHeader(name, line, cells, columns);
                return;
            }
            if (cells.length != columns.size()) {
                throw BadInputException.at(
                        name,
                        "line " + line,
                        "found " + cells.length + " cells, expected " + columns.size() + " as in the header");
            }
            rows.add(cells);
            lines.add(line);
        });
        if (columns.isEmpty()) {
            throw BadInputException.at(name, "line 1", "found nothing, expected a line of column names");
        }
        return new CsvTable(name, delimiter == ';', columns, rows, lines);
    }

    /**
     * Parses the first columns of a table with commas. A row with fewer cells lacks the last ones: they are empty.
     * Cells behind these columns may be anything.
     *
     * @param name name for error messages
     * @param columns names of the columns; the first line of the text is not read
     */
    public static CsvTable parseFirst(String name, String text, List<String> columns) {
        List<String[]> rows = new ArrayList<>();
        List<Long> lines = new ArrayList<>();
        forEachRecord(name, text, ',', null, (line, cells) -> {
            String[] row = Arrays.copyOf(cells, columns.size());
            for (int i = cells.length; i < row.length; i++) {
                row[i] = "";
            }
            rows.add(row);
            lines.add(line);
        });
        int from = Math.min(1, rows.size());
        return of(name, columns, rows.subList(from, rows.size()), lines.subList(from, lines.size()));
    }

    /** Calls {@code each} with the first line and the cells of each record that is not blank. */
    private static void forEachRecord(
            String name, String content, char delimiter, Character comment, BiConsumer<Long, String[]> each) {
        CSVFormat format = CSVFormat.RFC4180
                .builder()
                .setDelimiter(delimiter)
                .setCommentMarker(comment)
                .setIgnoreEmptyLines(false)
                .setIgnoreSurroundingSpaces(true)
                .get();
        long line = 1;
        try (CSVParser parser = CSVParser.parse(new StringReader(content), format)) {
            long linesBefore = 0;
            for (CSVRecord record : parser) {
                line = linesBefore + 1;
                linesBefore = parser.getCurrentLineNumber();
                String[] cells = record.values();
                if (cells.length > 1 || !cells[0].isBlank()) {
                    each.accept(line, cells);
                }
            }
        } catch (IOException | UncheckedIOException broken) {
            throw new BadInputException(
                    name + ": after line " + line + ": found a quoted cell that is broken, expected a closing quote"
                            + " before the delimiter",
                    broken);
        }
    }

    private static void readHeader(String name, long line, String[] cells, Map<String, Integer> columns) {
        for (String cell : cells) {
            String column = cell.strip();
            if (column.isEmpty()) {
                throw BadInputException.at(
                        name, "line " + line, "found column " + (columns.size() + 1) + " without a name, expected one");
            }
            if (columns.put(column, columns.size()) != null) {
                throw BadInputException.at(
                        name,
                        "line " + line,
                        "found column " + Numbers.quote(column) + " a second time, expected different names");
            }
        }
    }

    /** The semicolon if the first line has one outside quotes, otherwise the comma. */
    private static char delimiter(String content) {
        boolean quoted = false;
        for (int i = 0; i < content.length(); i++) {
            char c = content.charAt(i);
            if (c == '"') {
                quoted = !quoted;
            } else if (!quoted && c == ';') {
                return ';';
            } else if (!quoted && c == '\n' && !content.substring(0, i).isBlank()) {
                break;
            }
        }
        return ',';
    }

    public int rowCount() {
        return rows.size();
    }

    /** Names of the columns, left to right. */
    public List<String> columnNames() {
        return List.copyOf(columns.keySet());
    }

    public boolean has(String column) {
        return columns.containsKey(column);
    }

    /**
     * A column of finite numbers, top to bottom.
     *
     * @throws BadInputException if there is no such column or a cell is not a finite number
     */
    public double[] numbers(String column) {
        int at = index(column);
        double[] numbers = new double[rows.size()];
        for (int row = 0; row < numbers.length; row++) {
            String cell = rows.get(row)[at].strip();
            OptionalDouble value = Numbers.parse(decimalComma ? cell.replace(',', '.') : cell);
            if (value.isEmpty()) {
                throw badCell(row, column, "found " + Numbers.quote(cell) + ", expected a number");
            }
            numbers[row] = value.getAsDouble();
        }
        return numbers;
    }

    /**
     * A column of texts, top to bottom.
     *
     * @throws BadInputException if there is no such column
     */
    public List<String> texts(String column) {
        int at = index(column);
        return rows.stream().map(row -> row[at].strip()).toList();
    }

    /** The text of a cell, without spaces around it. */
    public String text(int row, String column) {
        return rows.get(row)[index(column)].strip();
    }

    /** An exception about one cell, naming file, line and column. */
    public BadInputException badCell(int row, String column, String problem) {
        return BadInputException.at(file, "line " + lines.get(row) + ", column '" + column + "'", problem);
    }

    private int index(String column) {
        Integer at = columns.get(column);
        if (at == null) {
            throw BadInputException.at(
                    file,
                    "line 1",
                    "found columns " + String.join(", ", columns.keySet()) + ", expected a column '" + column + "'");
        }
        return at;
    }
}
