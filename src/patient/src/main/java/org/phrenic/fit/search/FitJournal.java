package org.phrenic.fit.search;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.document.CsvTable;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.OutputException;

/**
 * What a fit has tried, a line an evaluation, written through as each is done: a fit that was killed goes on from here.
 * A line carries the mark of its fit; a last line that was cut off is dropped. Shapes that the search learns from lie
 * in a file beside it.
 */
public final class FitJournal implements AutoCloseable {
    private final Path file;
    private final String mark;
    private final List<String> columns = new ArrayList<>();
    private final Map<Integer, EvaluatedPoint> known = new TreeMap<>();
    private final ShapeFile shapes;
    private BufferedWriter writer;

    /**
     * Reads what is there; writes nothing yet.
     *
     * @param mark of the fit: one that asks for other things has another
     * @param parameters whose values stand in the columns
     * @throws BadInputException if the file is of another fit
     */
    public FitJournal(Path file, String mark, List<FitParameter> parameters) {
        this.file = file;
        this.mark = mark;
        columns.addAll(List.of("evaluation", "fit", "distance_mm"));
        parameters.forEach(p -> columns.add(p.parameter().key()));
        if (Files.exists(file)) {
            read(parameters);
        }
        String name = String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
        shapes = new ShapeFile(file.resolveSibling(name + ".shapes"), mark);
    }

    private void read(List<FitParameter> parameters) {
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
        List<String> marks = table.has("fit") ? table.texts("fit") : List.of("");
        if (!table.columnNames().equals(columns) || !marks.stream().allMatch(mark::equals)) {
            throw new BadInputException(
                    file + ": found the evaluations of another fit, expected those of this one or" + " another folder");
        }
        double[] numbers = table.numbers("evaluation");
        double[] values = table.numbers("distance_mm");
        double[][] given =
                parameters.stream().map(p -> table.numbers(p.parameter().key())).toArray(double[][]::new);
        for (int row = 0; row < numbers.length; row++) {
            double[] point = new double[given.length];
            for (int i = 0; i < point.length; i++) {
                point[i] = given[i][row];
            }
            known.put((int) numbers[row], new EvaluatedPoint(point, values[row]));
        }
    }

    /** What is known of an evaluation; null if it has not been made. */
    synchronized EvaluatedPoint known(int number) {
        return known.get(number);
    }

    /** Shape of an evaluation; null if it was not kept. */
    float[] shape(int number) {
        return shapes.shape(number);
    }

    /** Writes an evaluation and its shape. */
    void add(int number, EvaluatedPoint trial, float[] shape) {
        // The shape first: an evaluation that is known has one.
        shapes.add(number, shape);
        add(number, trial);
    }

    /** How many evaluations are known. */
    synchronized int size() {
        return known.size();
    }

    /** Writes an evaluation. */
    synchronized void add(int number, EvaluatedPoint trial) {
        try {
            if (writer == null) {
                open();
            }
            writer.write(line(number, trial));
            writer.flush();
        } catch (IOException e) {
            throw new OutputException(file + ": found no way to write, expected room for the journal", e);
        }
        known.put(number, trial);
    }

    private void open() throws IOException {
        // Written anew first, so that a line that was cut off is gone.
        StringBuilder text = new StringBuilder(String.join(",", columns)).append('\n');
        known.forEach((number, trial) -> text.append(line(number, trial)));
        AtomicFile.write(file, text.toString());
        writer = Files.newBufferedWriter(file, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
    }

    private String line(int number, EvaluatedPoint trial) {
        StringBuilder text = new StringBuilder();
        text.append(number).append(',').append(mark).append(',').append(trial.value());
        for (double value : trial.point()) {
            text.append(',').append(value);
        }
        return text.append('\n').toString();
    }

    @Override
    public synchronized void close() {
        shapes.close();
        if (writer != null) {
            try {
                writer.close();
            } catch (IOException e) {
                throw new OutputException(file + ": found no way to write, expected room for the journal", e);
            }
        }
    }
}
