package org.phrenic.fit.search;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.phrenic.document.CsvTable;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.file.Hashes;
import org.phrenic.file.OutputException;

/**
 * Log of the evaluations of a fit, one per line. Each line is written as soon as its evaluation is done, so an
 * interrupted fit can resume. The parameter values are the requested ones, also if the breath succeeded only with less
 * drive. A line contains the fingerprint of its fit and the build of the program. An incomplete last line is ignored.
 * Shapes are stored in a {@link ShapeFile} next to the journal.
 */
public final class FitJournal {
    private static final int FIXED_COLUMNS = 6;

    private static final String PROGRAM = "program";

    private final Path file;
    private final String fingerprint;
    private final String program;
    private final List<String> columns =
            new ArrayList<>(List.of("evaluation", "fit", PROGRAM, "distance_mm", "drive", "failure"));
    private final Map<Integer, Evaluation> known = new TreeMap<>();
    private final ShapeFile shapes;
    /** Length of the complete lines; 0 until the first is written. */
    private long end;

    /**
     * Reads an existing journal without modifying it.
     *
     * @param fingerprint identifies the inputs of the fit
     * @param program identifies the build of the program that computes
     * @param parameters parameters whose values are stored in the columns
     * @throws ForeignJournalException if the file belongs to another fit, or was written by another build: a search
     *     goes on from each of its evaluations
     */
    public FitJournal(Path file, String fingerprint, String program, List<FitParameter> parameters) {
        this.file = file;
        this.fingerprint = fingerprint;
        this.program = program;
        parameters.forEach(p -> columns.add(p.parameter().key()));
        if (Files.exists(file)) {
            read();
        }
        String name = FileNames.withoutExtension(file);
        shapes = new ShapeFile(file.resolveSibling(name + ".shapes"), mark());
    }

    /** What identifies the shapes of this fit and build. */
    private String mark() {
        return Hashes.sha256((fingerprint + program).getBytes(StandardCharsets.UTF_8));
    }

    private void read() {
        String text;
        try {
            text = Files.readString(file);
        } catch (IOException e) {
            throw new BadInputException(file + ": found nothing that can be read, expected the journal of a fit", e);
        }
        String whole = text.substring(0, text.lastIndexOf('\n') + 1);
        if (whole.isEmpty()) {
            return;
        }
        CsvTable table = CsvTable.parse(file.toString(), whole);
        requireProgram(table);
        if (!table.columnNames().equals(columns) || !table.texts("fit").stream().allMatch(fingerprint::equals)) {
            throw new ForeignJournalException(
                    file + ": found the evaluations of another fit, expected those of this one" + anew());
        }
        double[] numbers = table.numbers("evaluation");
        double[] values = table.numbers("distance_mm");
        double[] drives = table.numbers("drive");
        List<String> failures = table.texts("failure");
        double[][] given =
                columns.stream().skip(FIXED_COLUMNS).map(table::numbers).toArray(double[][]::new);
        for (int row = 0; row < numbers.length; row++) {
            double[] point = new double[given.length];
            for (int i = 0; i < point.length; i++) {
                point[i] = given[i][row];
            }
            known.put(
                    (int) numbers[row],
                    new Evaluation(point, values[row], new float[0], drives[row], failures.get(row)));
        }
    }

    private void requireProgram(CsvTable table) {
        Set<String> programs = table.columnNames().contains(PROGRAM)
                ? new TreeSet<>(table.texts(PROGRAM))
                : Set.of("an earlier version");
        if (!Set.of(program).containsAll(programs)) {
            throw new ForeignJournalException(file + ": found evaluations of another build of the program ("
                    + String.join("; ", programs) + "), expected those of this one (" + program + ")" + anew());
        }
    }

    private static String anew() {
        return "; another folder begins anew, or this one without the file and its .shapes";
    }

    /** The evaluation with this number, without its shape; null if it is not in the journal. */
    synchronized Evaluation known(int number) {
        return known.get(number);
    }

    /**
     * As {@link #known(int)}.
     *
     * @param point values that the search asks for
     * @throws ForeignJournalException if the evaluation has other values
     */
    Evaluation known(int number, double[] point) {
        Evaluation found = known(number);
        if (found != null && !Arrays.equals(found.point(), point)) {
            throw new ForeignJournalException(
                    file + ": found evaluation " + number + " at other values of the parameters than the search asks"
                            + " for, expected the evaluations of this fit" + anew());
        }
        return found;
    }

    /** Shape of an evaluation, or null if it is not stored. */
    float[] shape(int number) {
        return shapes.shape(number);
    }

    /** Writes an evaluation. Its shape, if stored, is written first. */
    void add(int number, Evaluation evaluation, boolean withShape) {
        if (withShape) {
            shapes.add(number, evaluation.shape());
        }
        synchronized (this) {
            known.put(number, evaluation.withoutShape());
            try {
                if (end > 0) {
                    append(line(number).getBytes(StandardCharsets.UTF_8));
                } else {
                    // The file is rewritten once to remove an incomplete last line.
                    StringBuilder text = new StringBuilder(String.join(",", columns)).append('\n');
                    known.keySet().forEach(k -> text.append(line(k)));
                    AtomicFile.write(file, text.toString());
                    end = Files.size(file);
                }
            } catch (IOException e) {
                throw new OutputException(file + ": found no way to write, expected room for the journal", e);
            }
        }
    }

    /** Appends to the complete lines, in place of the part of a line that a failed attempt may have left. */
    private void append(byte[] line) throws IOException {
        // Fails where the file is gone, which the next line would make.
        long size = Files.size(file);
        try (RandomAccessFile out = new RandomAccessFile(file.toFile(), "rw")) {
            byte[] rest = new byte[(int) Math.max(0, size - (end - 1))];
            out.seek(end - 1);
            out.readFully(rest);
            if (new String(rest, StandardCharsets.UTF_8).lastIndexOf('\n') != 0) {
                throw new OutputException(
                        file + ": found other lines than this fit has written, expected a journal that no other"
                                + " program changes",
                        null);
            }
            out.setLength(end);
            out.seek(end);
            out.write(line);
        }
        end += line.length;
    }

    private String line(int number) {
        StringBuilder text = new StringBuilder();
        Evaluation e = known.get(number);
        text.append(number).append(',').append(fingerprint).append(',').append(program);
        text.append(',')
                .append(e.value())
                .append(',')
                .append(e.drive())
                .append(',')
                .append(e.failure());
        for (double value : e.point()) {
            text.append(',').append(value);
        }
        return text.append('\n').toString();
    }
}
