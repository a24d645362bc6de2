package org.phrenic.study.sweep.run;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.TextFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepModel;
import org.phrenic.study.sweep.SweepOutcome;
import org.phrenic.study.sweep.SweepStudy;

/**
 * The completed runs of a study in a CSV file to which each run appends a line, in the order of completion. A last line
 * without its line feed, which a killed process leaves, is dropped. One process at a time writes a journal, where the
 * file system has locks.
 *
 * <p>Each line states the fingerprint of the plan that it belongs to. A journal without that column is taken as one of
 * the plan, and goes on without it.
 */
final class SweepJournal implements AutoCloseable {
    private static final List<String> FIXED = SweepStudy.JOURNAL_COLUMNS;

    /** Beyond all content: Windows lets nobody read bytes that are locked, and other shards read the journal. */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;

    /** Locks a file against other processes. */
    interface Locking {
        /** The lock; null if another process has it. */
        FileLock tryLock(FileChannel channel) throws IOException;
    }

    private final RandomAccessFile file;
    private final Path path;
    /** What a line states of its plan; empty in a journal without that column. */
    private final List<String> plan;
    /** Length of the complete lines. */
    private long end;

    /**
     * Opens a journal for appending, after its last complete line.
     *
     * @param plan fingerprint of the plan of the runs
     */
    SweepJournal(Path path, SweepModel model, String plan) {
        this(path, opened(path), channel -> channel.tryLock(LOCKED_BYTE, 1, false), model, plan);
    }

    /** @param file to read and write {@code path} */
    SweepJournal(Path path, RandomAccessFile file, Locking locking, SweepModel model, String plan) {
        this.path = path;
        this.file = file;
        try {
            if (isWrittenElsewhere(locking, file.getChannel())) {
                throw new BadInputException(path + ": found a journal that another process writes, expected none"
                        + " (the study runs already)");
            }
            end = completeLength();
            this.plan = end > 0 && !statesPlan() ? List.of() : List.of(plan);
            if (end == 0) {
                append(CsvWriter.format(header(model, true), List.of()));
            }
        } catch (IOException failure) {
            close();
            throw failed(path, failure);
        } catch (RuntimeException refused) {
            close();
            throw refused;
        }
    }

    private static RandomAccessFile opened(Path path) {
        try {
            return new RandomAccessFile(path.toFile(), "rw");
        } catch (IOException failure) {
            throw failed(path, failure);
        }
    }

    /** A file system without locks, as some shared ones are, tells of no other process. */
    private static boolean isWrittenElsewhere(Locking locking, FileChannel channel) {
        try {
            return locking.tryLock(channel) == null;
        } catch (OverlappingFileLockException mine) {
            return true;
        } catch (IOException noLocks) {
            return false;
        }
    }

    private static OutputException failed(Path path, IOException failure) {
        return new OutputException(path + ": writing failed: " + failure.getMessage(), failure);
    }

    private static List<String> header(SweepModel model, boolean withPlan) {
        List<String> header = new ArrayList<>(FIXED);
        if (withPlan) {
            header.add(SweepStudy.PLAN_COLUMN);
        }
        header.addAll(model.responses());
        header.addAll(seriesColumns(model));
        return header;
    }

    /** Whether the first line, which is complete, has the column of the plan. */
    private boolean statesPlan() throws IOException {
        file.seek(0);
        String header = new String(file.readLine().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
        return CsvTable.parse(path.toString(), header).has(SweepStudy.PLAN_COLUMN);
    }

    private static List<String> seriesColumns(SweepModel model) {
        return model.series().stream().map(SweepStudy::seriesColumn).toList();
    }

    private long completeLength() throws IOException {
        long length = file.length();
        while (length > 0) {
            file.seek(length - 1);
            if (file.read() == '\n') {
                return length;
            }
            length--;
        }
        return 0;
    }

    /** Appends to the complete lines, in place of the part of a line that a failed attempt may have left. */
    private void append(String text) throws IOException {
        byte[] line = text.getBytes(StandardCharsets.UTF_8);
        if (file.length() > end) {
            file.setLength(end);
        }
        file.seek(end);
        file.write(line);
        end += line.length;
    }

    /** Appends a run. */
    void add(RunRow row) {
        List<String> cells = new ArrayList<>();
        cells.add(String.valueOf(row.index()));
        cells.add(row.failure());
        cells.add(CsvWriter.number(row.wallS(), 4));
        cells.add(row.outcome().stateSha256());
        cells.add(row.machine());
        cells.addAll(plan);
        DoubleStream.of(row.outcome().responses()).forEach(v -> cells.add(text(v)));
        for (double[] values : row.outcome().series()) {
            cells.add(DoubleStream.of(values).mapToObj(SweepJournal::text).collect(Collectors.joining(";")));
        }
        String line = CsvWriter.format(cells, List.of());
        try {
            append(line);
        } catch (IOException failure) {
            throw failed(path, failure);
        }
    }

    private static String text(double value) {
        return CsvWriter.number(value, CsvWriter.ALL_DIGITS);
    }

    /**
     * Reads the complete lines of a journal.
     *
     * @param plan fingerprint of the plan of the runs
     * @throws BadInputException with one sentence, if it is none of this model and plan, or a line is damaged
     */
    static List<RunRow> read(Path path, SweepModel model, String plan) {
        try {
            if (Files.size(path) == 0) {
                return List.of();
            }
        } catch (IOException failure) {
            throw InputBytes.readFailure(path, failure);
        }
        byte[] bytes = InputBytes.read(path);
        int length = bytes.length;
        while (length > 0 && bytes[length - 1] != '\n') {
            length--;
        }
        if (length == 0) {
            return List.of();
        }
        // A last line that is incomplete may end within a letter.
        String complete = TextFile.decode(path, Arrays.copyOf(bytes, length), "a journal");
        CsvTable table = CsvTable.parse(path.toString(), complete);
        boolean withPlan = table.has(SweepStudy.PLAN_COLUMN);
        if (!table.columnNames().equals(header(model, withPlan))) {
            throw new BadInputException(path + ": found other columns, expected the journal of this study");
        }
        return IntStream.range(0, table.rowCount())
                .mapToObj(r -> new Line(table, r).row(model, withPlan ? plan : ""))
                .toList();
    }

    /** A line of a journal. */
    private record Line(CsvTable table, int number) {
        /** @param plan fingerprint of the plan; empty if the line states none */
        RunRow row(SweepModel model, String plan) {
            if (!plan.isEmpty() && !text(SweepStudy.PLAN_COLUMN).equals(plan)) {
                throw table.badCell(
                        number,
                        SweepStudy.PLAN_COLUMN,
                        "found a run of another study (" + Numbers.quote(text(SweepStudy.PLAN_COLUMN)) + "), expected '"
                                + plan + "', as this study's factors, points and settings have it");
            }
            double[] responses =
                    model.responses().stream().mapToDouble(this::number).toArray();
            double[][] series = seriesColumns(model).stream().map(this::series).toArray(double[][]::new);
            int index = (int) Numbers.parseWhole(text("index"), 0, Integer.MAX_VALUE)
                    .orElseThrow(() -> bad("index", text("index"), "a whole number"));
            SweepOutcome outcome = new SweepOutcome(responses, text("state_sha256"), series);
            return new RunRow(index, outcome, text("failure"), number("wall_s"), text("machine"));
        }

        private String text(String column) {
            return table.text(number, column);
        }

        private double number(String column) {
            return number(column, text(column));
        }

        private double[] series(String column) {
            double[] values = Stream.of(text(column).split(";", -1))
                    .mapToDouble(text -> number(column, text))
                    .toArray();
            if (values.length != SweepOutcome.SERIES_POINTS) {
                throw bad(column, values.length + " numbers", SweepOutcome.SERIES_POINTS + " numbers");
            }
            return values;
        }

        /** A number as {@link SweepJournal#text} writes it. */
        private double number(String column, String text) {
            if (text.isEmpty()) {
                return Double.NaN;
            }
            if (text.equals("Infinity") || text.equals("-Infinity")) {
                return text.startsWith("-") ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
            }
            return Numbers.parse(text).orElseThrow(() -> bad(column, Numbers.quote(text), "a number"));
        }

        private BadInputException bad(String column, String found, String expected) {
            return table.badCell(
                    number,
                    column,
                    "found " + found + ", expected " + expected + " (a run whose line is deleted is computed again)");
        }
    }

    @Override
    public void close() {
        try {
            file.close();
        } catch (IOException failure) {
            throw failed(path, failure);
        }
    }
}
