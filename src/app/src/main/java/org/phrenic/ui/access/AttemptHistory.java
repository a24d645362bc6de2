package org.phrenic.ui.access;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.document.CsvTable;
import org.phrenic.document.TextFile;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;

/**
 * The attempts of all sessions, a row each in a CSV file on this machine: the learning curve of its user. A row that
 * cannot be written, as while another program has the file open, waits here and is written later.
 */
public final class AttemptHistory {
    private static final String HEADER =
            "session,time,exercise,help,hit,distance_mm,axial_mm,lateral_mm,time_s,no_go_s,"
                    + "probe_s,tip_out_of_beam_s,needle_in_beam_mm,needle_in_beam_share,aims_by_program,"
                    + "greatest_force_n,capsule_push_mm,side_load_n,bending_mm";

    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss", Locale.ROOT);

    /** Attempts at either end of a learning curve whose mean is taken. */
    private static final int ENDS = 5;

    private final Path file;
    private final String session;
    private final List<String> waiting = new ArrayList<>();

    /**
     * A history in a file.
     *
     * @param file the CSV file; made by the first attempt
     * @param session begin of the session, which tells sessions apart
     */
    public AttemptHistory(Path file, String session) {
        this.file = file;
        this.session = session;
    }

    public Path file() {
        return file;
    }

    /** The history in a folder, from a session that begins now. */
    public static AttemptHistory in(Path folder) {
        return new AttemptHistory(folder.resolve("attempts.csv"), now());
    }

    /** A time in whole seconds; each has as many characters. */
    static String text(LocalDateTime time) {
        return TIME.format(time);
    }

    private static String now() {
        return text(LocalDateTime.now(ZoneId.systemDefault()));
    }

    /**
     * Adds an attempt, after those that wait.
     *
     * @throws OutputException if the file cannot be written; the attempt waits then
     * @throws BadInputException if the file cannot be read, or is another table; the attempt waits then
     */
    public void add(Rehearsal attempt) {
        waiting.add(row(attempt));
        writeWaiting();
    }

    /**
     * Writes the attempts that wait, if there are any.
     *
     * @throws OutputException if the file cannot be written
     * @throws BadInputException if the file cannot be read, or is another table
     */
    public void writeWaiting() {
        if (!waiting.isEmpty()) {
            AtomicFile.write(file, String.join("\n", lines()) + "\n");
            waiting.clear();
        }
    }

    /** Writes the attempts that wait; where that fails, asks with the reason whether to try again. */
    public void writeWaiting(Predicate<String> again) {
        boolean ended = false;
        while (!ended) {
            try {
                writeWaiting();
                ended = true;
            } catch (OutputException | BadInputException e) {
                ended = !again.test(e.getMessage());
            }
        }
    }

    /** How many attempts are not in the file yet. */
    public int waiting() {
        return waiting.size();
    }

    private String row(Rehearsal attempt) {
        AttemptRecord record = attempt.record();
        List<String> cells =
                new ArrayList<>(List.of(session, now(), quoted(attempt.plan().title())));
        cells.add(attempt.plan().aids().key());
        cells.addAll(record.last().map(AttemptHistory::sampleCells).orElse(List.of("", "", "", "")));
        cells.add(number(record.timeS()));
        cells.add(number(record.inNoGoS()));
        cells.add(number(attempt.probe().probeS()));
        cells.add(number(attempt.probe().tipUnseenS()));
        cells.add(number(attempt.probe().needleInBeamMm()));
        cells.add(number(attempt.probe().needleInBeamShare()));
        cells.add(Long.toString(attempt.plan().aimsByProgram()));
        cells.add(number(record.loads().greatestN()));
        cells.add(number(record.loads().capsulePushMm()));
        cells.add(number(record.loads().sideN()));
        cells.add(number(record.loads().bendingMm()));
        return String.join(",", cells);
    }

    private static List<String> sampleCells(TargetingError sample) {
        return List.of(
                Boolean.toString(sample.hit()),
                number(sample.distanceMm()),
                number(sample.axialMm()),
                number(sample.lateralMm()));
    }

    /** A title without what separates cells and rows. */
    private static String quoted(String title) {
        return title.replaceAll("[,\"\\r\\n]+", " ").strip();
    }

    private static String number(double value) {
        return Numbers.format("%.2f", value);
    }

    /** The header and all rows: those of the file, then those that wait. */
    private List<String> lines() {
        List<String> lines = new ArrayList<>();
        if (Files.isRegularFile(file) && file.toFile().length() > 0) {
            lines.addAll(TextFile.read(file, "a table in UTF-8").lines().toList());
            lines.set(0, header(lines.get(0)));
        } else {
            lines.add(HEADER);
        }
        lines.addAll(waiting);
        return lines;
    }

    /**
     * The header for a file: its own, with the columns that it lacks, which come last. It may have columns of a user
     * behind all of them.
     */
    private String header(String line) {
        String[] expected = HEADER.split(",", -1);
        String[] found = line.replace("\"", "").split(",", -1);
        for (int i = 0; i < Math.min(found.length, expected.length); i++) {
            if (!found[i].strip().equals(expected[i])) {
                throw BadInputException.at(
                        file.toString(),
                        "line 1",
                        "found " + Numbers.quote(found[i]) + " as column " + (i + 1)
                                + " of a table with commas, expected " + Numbers.quote(expected[i]));
            }
        }
        return found.length < expected.length ? HEADER : line;
    }

    /** All rows, in the program's columns. */
    private CsvTable table() {
        return CsvTable.parseFirst(file.toString(), String.join("\n", lines()), List.of(HEADER.split(",")));
    }

    /**
     * The learning curve of an exercise in words; empty before its first sample.
     *
     * @throws BadInputException if the file cannot be read or a distance in it is not a number
     */
    public String learningCurve(String exercise) {
        CsvTable table = table();
        List<String> titles = table.texts("exercise");
        List<String> distances = table.texts("distance_mm");
        int[] rows = IntStream.range(0, titles.size())
                .filter(row -> titles.get(row).equals(quoted(exercise))
                        && !distances.get(row).isEmpty())
                .toArray();
        if (rows.length == 0) {
            return "";
        }
        double[] mm = IntStream.of(rows)
                .mapToDouble(row -> Numbers.parse(distances.get(row))
                        .orElseThrow(() -> table.badCell(
                                row,
                                "distance_mm",
                                "found " + Numbers.quote(distances.get(row)) + ", expected a number")))
                .toArray();
        List<String> hit = table.texts("hit");
        List<String> begun = table.texts("session");
        long hits = IntStream.of(rows)
                .filter(row -> Boolean.parseBoolean(hit.get(row)))
                .count();
        long sessions = IntStream.of(rows).mapToObj(begun::get).distinct().count();
        String ends = mm.length < 2 * ENDS
                ? ""
                : Numbers.format(
                        "; the first %d %.1f mm, the last %d %.1f mm",
                        ENDS, StatUtils.mean(mm, 0, ENDS), ENDS, StatUtils.mean(mm, mm.length - ENDS, ENDS));
        return Numbers.format(
                "This exercise: %s in %s, %s, %.1f%s mm off%s.",
                count(mm.length, "sample"),
                count(sessions, "session"),
                count(hits, "hit"),
                StatUtils.mean(mm),
                mm.length < 2 ? "" : Numbers.format(" \u00b1 %.1f", new StandardDeviation().evaluate(mm)),
                ends);
    }

    private static String count(long number, String what) {
        return number + " " + what + (number == 1 ? "" : "s");
    }

    /**
     * Writes a copy of the history.
     *
     * @throws OutputException if it cannot be written
     */
    public void export(Path to) {
        AtomicFile.write(to, String.join("\n", lines()) + "\n");
    }
}
