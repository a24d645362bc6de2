package org.phrenic.study.sweep.run;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.TextFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepModel;
import org.phrenic.study.sweep.SweepOutcome;
import org.phrenic.study.sweep.SweepStudy;

/**
 * The completed runs of a study in a CSV file to which each run appends a line, in the order of completion. A last line
 * without its line feed, which a killed process leaves, is dropped. One process at a time writes a journal.
 */
final class SweepJournal implements AutoCloseable {
    private static final List<String> FIXED = SweepStudy.JOURNAL_COLUMNS;

    /** Beyond all content: Windows lets nobody read bytes that are locked, and other shards read the journal. */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;

    private final RandomAccessFile file;
    private final Path path;

    /** Opens a journal for appending, after its last complete line. */
    SweepJournal(Path path, SweepModel model) {
        this.path = path;
        try {
            file = new RandomAccessFile(path.toFile(), "rw");
            FileLock lock = lock();
            if (lock == null) {
                file.close();
                throw new BadInputException(path + ": found a journal that another process writes, expected none"
                        + " (the study runs already)");
            }
            file.setLength(completeLength());
            file.seek(file.length());
            if (file.length() == 0) {
                append(CsvWriter.format(header(model), List.of()));
            }
        } catch (IOException failure) {
            throw failed(failure);
        }
    }

    private FileLock lock() throws IOException {
        try {
            return file.getChannel().tryLock(LOCKED_BYTE, 1, false);
        } catch (OverlappingFileLockException mine) {
            return null;
        }
    }

    private OutputException failed(IOException failure) {
        return new OutputException(path + ": writing failed: " + failure.getMessage(), failure);
    }

    private static List<String> header(SweepModel model) {
        List<String> header = new ArrayList<>(FIXED);
        header.addAll(model.responses());
        header.addAll(seriesColumns(model));
        return header;
    }

    private static List<String> seriesColumns(SweepModel model) {
        return model.series().stream().map(name -> "series " + name).toList();
    }

    private long completeLength() throws IOException {
        long end = file.length();
        while (end > 0) {
            file.seek(end - 1);
            if (file.read() == '\n') {
                return end;
            }
            end--;
        }
        return 0;
    }

    private void append(String text) throws IOException {
        file.write(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Appends a run. */
    void add(RunRow row) {
        List<String> cells = new ArrayList<>();
        cells.add(String.valueOf(row.index()));
        cells.add(row.failure());
        cells.add(CsvWriter.number(row.wallS(), 4));
        cells.add(row.outcome().stateSha256());
        cells.add(row.machine());
        DoubleStream.of(row.outcome().responses()).forEach(v -> cells.add(text(v)));
        for (double[] values : row.outcome().series()) {
            cells.add(DoubleStream.of(values).mapToObj(SweepJournal::text).collect(Collectors.joining(";")));
        }
        String line = CsvWriter.format(cells, List.of());
        try {
            append(line);
        } catch (IOException failure) {
            throw failed(failure);
        }
    }

    private static String text(double value) {
        return CsvWriter.number(value, CsvWriter.ALL_DIGITS);
    }

    /**
     * Reads the complete lines of a journal.
     *
     * @throws BadInputException with one sentence, if it is none of this model
     */
    static List<RunRow> read(Path path, SweepModel model) {
        String text = TextFile.read(path, "a journal");
        String complete = text.substring(0, text.lastIndexOf('\n') + 1);
        if (complete.isEmpty()) {
            return List.of();
        }
        CsvTable table = CsvTable.parse(path.toString(), complete);
        List<String> header = header(model);
        if (!List.copyOf(table.columnNames()).equals(header)) {
            throw new BadInputException(path + ": found other columns, expected the journal of this study");
        }
        List<List<String>> columns = header.stream().map(table::texts).toList();
        List<RunRow> rows = new ArrayList<>();
        for (int r = 0; r < table.rowCount(); r++) {
            int at = r;
            rows.add(row(columns.stream().map(column -> column.get(at)).toList(), model, path));
        }
        return rows;
    }

    private static RunRow row(List<String> cells, SweepModel model, Path path) {
        int count = model.responses().size();
        double[] responses = new double[count];
        for (int i = 0; i < count; i++) {
            responses[i] = number(cells.get(FIXED.size() + i));
        }
        double[][] series = new double[model.series().size()][];
        for (int i = 0; i < series.length; i++) {
            String[] values = cells.get(FIXED.size() + count + i).split(";", -1);
            series[i] =
                    List.of(values).stream().mapToDouble(SweepJournal::number).toArray();
        }
        long index = Numbers.parseWhole(cells.get(0), 0, Integer.MAX_VALUE)
                .orElseThrow(() -> new BadInputException(
                        path + ": found the index '" + cells.get(0) + "', expected a whole number"));
        SweepOutcome outcome = new SweepOutcome(responses, cells.get(3), series);
        return new RunRow((int) index, outcome, cells.get(1), number(cells.get(2)), cells.get(4));
    }

    private static double number(String text) {
        return Numbers.parse(text).orElse(Double.NaN);
    }

    @Override
    public void close() {
        try {
            file.close();
        } catch (IOException failure) {
            throw failed(failure);
        }
    }
}
