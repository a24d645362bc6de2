package org.phrenic.breathing;

import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/**
 * Reads recorded breathing.
 *
 * <p>Two layouts, told apart by their headers: {@code time_s,amplitude} (commas, decimal points), and the skin markers
 * of {@code Frame;Timestamp;x;y;z} (semicolons, decimal commas, ms and mm; T. Krilavicius et al. 2015), of which the
 * signal is the first principal component. Such files may end in a row of zeros, which is dropped. Times must rise; up
 * to 1 % of rows whose time does not (cameras that stamp some frames in another unit) are left out, more are refused.
 */
public final class BreathingTraceReader {
    private static final List<String> MARKER = List.of("Frame", "Timestamp", "x", "y", "z");
    private static final List<String> PLAIN = List.of("time_s", "amplitude");

    private static final double MAX_UNORDERED_SHARE = 0.01;

    private BreathingTraceReader() {}

    /**
     * Reads a trace.
     *
     * @throws IOException if it cannot be read or is none; the message names the file and the line
     */
    public static BreathingTrace read(Path file) throws IOException {
        String name = file.toString();
        try {
            String header;
            try (var lines = Files.newBufferedReader(file)) {
                header = lines.readLine();
            }
            boolean marker = header != null && header.indexOf(';') >= 0;
            return read(file, name, marker ? MARKER : PLAIN, marker);
        } catch (CharacterCodingException e) {
            throw notText(name, e);
        } catch (UncheckedIOException e) {
            // how the parser passes on what its reader throws
            if (e.getCause() instanceof CharacterCodingException) {
                throw notText(name, e);
            }
            throw new IOException(name + ": " + e.getCause().getMessage() + ", expected a CSV file", e);
        } catch (IllegalArgumentException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    private static BreathingTrace read(Path file, String name, List<String> columns, boolean marker)
            throws IOException {
        CSVFormat format = CSVFormat.DEFAULT
                .builder()
                .setDelimiter(marker ? ';' : ',')
                .setTrim(true)
                .setIgnoreEmptyLines(true)
                .get();
        List<double[]> rows = new ArrayList<>();
        List<Long> lines = new ArrayList<>();
        try (Reader reader = Files.newBufferedReader(file);
                CSVParser parser = CSVParser.parse(reader, format)) {
            boolean header = true;
            for (CSVRecord csv : parser) {
                String place = name + " line " + parser.getCurrentLineNumber();
                if (header) {
                    if (!withoutByteOrderMark(csv).equals(columns)) {
                        throw new IOException(name + " line 1: columns '" + String.join(" ", csv.toList())
                                + "', expected 'Frame;Timestamp;x;y;z' or 'time_s,amplitude'");
                    }
                    header = false;
                    continue;
                }
                rows.add(numbers(csv, columns, place));
                lines.add(parser.getCurrentLineNumber());
            }
        }
        if (marker && rows.size() > 1 && isZero(rows.get(rows.size() - 1))) {
            rows.remove(rows.size() - 1);
        }
        if (rows.isEmpty()) {
            throw new IOException(
                    name + ": no rows, expected 'Frame;Timestamp;x;y;z' or 'time_s,amplitude' and samples");
        }
        int dropped = dropUnordered(rows, lines, marker ? 1 : 0, name);
        double[] timeS = rows.stream()
                .mapToDouble(row -> marker ? row[1] / 1000 : row[0])
                .toArray();
        double[] signal = marker
                ? PrincipalComponent.firstComponent(name, rows, 2)
                : rows.stream().mapToDouble(row -> row[1]).toArray();
        return new BreathingTrace(name, timeS, signal, dropped);
    }

    /** Leaves out the few rows whose time does not rise; returns how many. */
    private static int dropUnordered(List<double[]> rows, List<Long> lines, int column, String name)
            throws IOException {
        List<double[]> ordered = new ArrayList<>();
        String first = null;
        for (int i = 0; i < rows.size(); i++) {
            double before = ordered.isEmpty() ? Double.NEGATIVE_INFINITY : ordered.get(ordered.size() - 1)[column];
            double time = rows.get(i)[column];
            if (time > before) {
                ordered.add(rows.get(i));
            } else if (first == null) {
                first = name + " line " + lines.get(i) + ": time " + time + ", expected more than the " + before
                        + " before it";
            }
        }
        int dropped = rows.size() - ordered.size();
        if (dropped > MAX_UNORDERED_SHARE * rows.size()) {
            throw new IOException(first + " (" + dropped + " of " + rows.size() + " rows are out of order)");
        }
        rows.clear();
        rows.addAll(ordered);
        return dropped;
    }

    private static IOException notText(String name, Exception cause) {
        return new IOException(name + ": not text in UTF-8, expected a CSV file of recorded breathing", cause);
    }

    /** The fields of the header, without the byte order mark that some programs put before it. */
    private static List<String> withoutByteOrderMark(CSVRecord header) {
        List<String> names = new ArrayList<>(header.toList());
        names.set(0, names.get(0).replace("\uFEFF", "").replace("\"", ""));
        return names;
    }

    private static double[] numbers(CSVRecord csv, List<String> columns, String place) throws IOException {
        if (csv.size() != columns.size()) {
            throw new IOException(place + ": " + csv.size() + " values, expected " + columns.size());
        }
        double[] values = new double[columns.size()];
        for (int i = 0; i < values.length; i++) {
            try {
                values[i] = Double.parseDouble(csv.get(i).replace(',', '.'));
            } catch (NumberFormatException e) {
                values[i] = Double.NaN;
            }
            if (!Double.isFinite(values[i])) {
                throw new IOException(place + ": " + columns.get(i) + " '" + csv.get(i) + "', expected a number");
            }
        }
        return values;
    }

    private static boolean isZero(double[] row) {
        for (double value : row) {
            if (value != 0) {
                return false;
            }
        }
        return true;
    }
}
