package org.phrenic.breathing;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.document.CsvTable;
import org.phrenic.document.TextFile;
import org.phrenic.file.BadInputException;

/**
 * Reads recorded breathing signals.
 *
 * <p>The header selects one of two formats. The first is {@code time_s,amplitude} (commas, decimal points). The second
 * has skin markers, {@code Frame;Timestamp;x;y;z} (semicolons, decimal commas, ms and mm; T. Krilavicius et al. 2015);
 * its signal is the first principal component. A row of zeros at the end of such a file is dropped. Times must
 * increase. Up to 1 % of rows with times that do not increase are dropped (some cameras stamp frames in another unit);
 * with more, the file is rejected.
 */
public final class BreathingTraceReader {
    private static final List<String> MARKER = List.of("Frame", "Timestamp", "x", "y", "z");
    private static final List<String> PLAIN = List.of("time_s", "amplitude");

    private static final String EXPECTED = "'Frame;Timestamp;x;y;z' or 'time_s,amplitude'";
    private static final double MAX_UNORDERED_SHARE = 0.01;

    private BreathingTraceReader() {}

    /**
     * Reads a trace.
     *
     * @throws BadInputException if the file cannot be read or is not a trace; the message names file and line
     */
    public static BreathingTrace read(Path file) {
        String name = file.toString();
        CsvTable table = CsvTable.parse(name, TextFile.read(file, "a CSV file of recorded breathing"));
        boolean marker = table.columnNames().equals(MARKER);
        if (!marker && !table.columnNames().equals(PLAIN)) {
            throw BadInputException.at(
                    name,
                    "line 1",
                    "found columns '" + String.join(" ", table.columnNames()) + "', expected " + EXPECTED);
        }
        double[][] columns = table.columnNames().stream().map(table::numbers).toArray(double[][]::new);
        int count = table.rowCount();
        if (marker && count > 1 && Arrays.stream(columns).allMatch(column -> column[column.length - 1] == 0)) {
            count--;
        }
        if (count == 0) {
            throw new BadInputException(name + ": found no rows, expected " + EXPECTED + " and samples");
        }
        int[] kept = inOrder(table, marker ? "Timestamp" : "time_s", count);
        double[] timeS = new double[kept.length];
        double[] signal = new double[kept.length];
        List<double[]> rows = new ArrayList<>();
        for (int i = 0; i < kept.length; i++) {
            int row = kept[i];
            timeS[i] = marker ? columns[1][row] / 1000 : columns[0][row];
            signal[i] = columns[1][row];
            rows.add(Arrays.stream(columns).mapToDouble(column -> column[row]).toArray());
        }
        try {
            double[] amplitude = marker ? PrincipalComponent.firstComponent(name, rows, 2) : signal;
            String read = marker ? "first principal component of columns x, y, z" : "column amplitude";
            return new BreathingTrace(name, read, timeS, amplitude, count - kept.length);
        } catch (IllegalArgumentException e) {
            throw new BadInputException(e.getMessage(), e);
        }
    }

    /** Indices of rows whose time exceeds that of every earlier row; throws if too many rows do not. */
    private static int[] inOrder(CsvTable table, String column, int count) {
        double[] time = table.numbers(column);
        int[] kept = new int[count];
        int rows = 0;
        int first = -1;
        double firstBefore = 0;
        for (int row = 0; row < count; row++) {
            double before = rows == 0 ? Double.NEGATIVE_INFINITY : time[kept[rows - 1]];
            if (time[row] > before) {
                kept[rows++] = row;
            } else if (first < 0) {
                first = row;
                firstBefore = before;
            }
        }
        if (count - rows > MAX_UNORDERED_SHARE * count) {
            throw table.badCell(
                    first,
                    column,
                    "found time " + time[first] + ", expected more than the " + firstBefore + " before it ("
                            + (count - rows) + " of " + count + " rows are out of order)");
        }
        return Arrays.copyOf(kept, rows);
    }
}
