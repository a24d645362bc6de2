package org.phrenic.document;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.OutputException;

/** Writes tables as CSV with commas, decimal points in every locale, and line feeds. NaN is an empty cell. */
public final class CsvWriter {
    /** Writes the shortest digits that read back as the same number. */
    public static final int ALL_DIGITS = 0;

    private static final CSVFormat FORMAT =
            CSVFormat.RFC4180.builder().setRecordSeparator("\n").get();

    private CsvWriter() {}

    /**
     * Formats a table of numbers.
     *
     * @param columns values by column name, left to right, all of the same length
     * @param digits significant digits, or {@link #ALL_DIGITS}
     * @throws IllegalArgumentException if the columns differ in length
     */
    public static String format(Map<String, double[]> columns, int digits) {
        List<double[]> values = List.copyOf(columns.values());
        int rows = values.isEmpty() ? 0 : values.get(0).length;
        columns.forEach((name, column) -> {
            if (column.length != rows) {
                throw new IllegalArgumentException(
                        "column '" + name + "': " + column.length + " values, expected " + rows);
            }
        });
        List<List<String>> cells = IntStream.range(0, rows)
                .mapToObj(row -> values.stream()
                        .map(column -> number(column[row], digits))
                        .toList())
                .toList();
        return format(List.copyOf(columns.keySet()), cells);
    }

    /** Formats a table of arbitrary cells; those with commas, quotes or line breaks are quoted. */
    public static String format(List<String> header, List<? extends List<?>> rows) {
        StringBuilder text = new StringBuilder();
        try {
            print(text, header, rows);
        } catch (IOException impossible) {
            throw new UncheckedIOException("a StringBuilder takes all text", impossible);
        }
        return text.toString();
    }

    private static void print(Appendable out, List<String> header, Iterable<? extends List<?>> rows)
            throws IOException {
        CSVPrinter printer = new CSVPrinter(out, FORMAT);
        printer.printRecord(header);
        for (List<?> row : rows) {
            printer.printRecord(row.stream().map(CsvWriter::cell));
        }
        printer.flush();
    }

    private static Object cell(Object value) {
        return value instanceof Double number ? number(number, ALL_DIGITS) : value;
    }

    /**
     * Writes a table of numbers to {@code file} atomically.
     *
     * @throws OutputException if the file cannot be written
     */
    public static void write(Path file, Map<String, double[]> columns, int digits) {
        AtomicFile.write(file, format(columns, digits));
    }

    /**
     * Writes a table of arbitrary cells to {@code file} atomically, row by row, without a copy of the table in memory.
     *
     * @throws OutputException if the file cannot be written
     */
    public static void write(Path file, List<String> header, Iterable<? extends List<?>> rows) {
        AtomicFile.write(file, out -> print(new OutputStreamWriter(out, StandardCharsets.UTF_8), header, rows));
    }

    /** Formats a cell: {@code Double.toString} of {@code value} rounded to {@code digits} significant digits. */
    public static String number(double value, int digits) {
        if (Double.isNaN(value)) {
            return "";
        }
        if (digits == ALL_DIGITS || Double.isInfinite(value)) {
            return Double.toString(value);
        }
        return Double.toString(
                new BigDecimal(value).round(new MathContext(digits)).doubleValue());
    }
}
