package org.phrenic.study.sweep.run;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.TextFile;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepModel;
import org.phrenic.study.sweep.SweepOutcome;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepPoint;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.report.SweepReport;

/**
 * The folder of a study: {@code study.yaml}, which a resumed study, a shard and a merge compare; journals; and the
 * results {@code runs.csv}, {@code series.csv}, {@code study.json} and {@code report.html}.
 */
public final class SweepFolder {
    private static final String STUDY = "study.yaml";
    private static final String RUNS = "runs.csv";
    private static final int PERCENT = 100;

    private final Path folder;
    private final SweepPlan plan;
    private final String fingerprint;

    private SweepFolder(Path folder, SweepPlan plan) {
        this.folder = folder;
        this.plan = plan;
        fingerprint = plan.fingerprint();
    }

    /**
     * The folder of a study, which is made if it is absent.
     *
     * @throws BadInputException with one sentence, if another study is in it, or journals of which no study is known,
     *     or if the study is too large to be read again
     */
    public static SweepFolder of(Path folder, SweepPlan plan) {
        return of(folder, plan, SweepFolder::journals);
    }

    /** @param lists the journals of a folder */
    static SweepFolder of(Path folder, SweepPlan plan, Function<Path, List<Path>> lists) {
        Path study = folder.resolve(STUDY);
        String text = plan.study().resolved();
        // Before the study is looked for: another shard that begins meanwhile writes the study before its journal.
        List<Path> journals = Files.isDirectory(folder) ? lists.apply(folder) : List.of();
        boolean hasRuns = Files.exists(folder.resolve(RUNS));
        if (!Files.exists(study)) {
            if (!journals.isEmpty()) {
                throw new BadInputException(folder + ": found "
                        + journals.get(0).getFileName() + " without " + STUDY + ", expected both or an empty folder");
            }
            if (hasRuns) {
                throw new BadInputException(folder + ": found " + RUNS + " without " + STUDY
                        + ", which would be written over, expected another folder");
            }
            requireReadable(study, text);
            AtomicFile.write(study, text);
        } else if (!stated(study).resolved().equals(text)) {
            throw new BadInputException(folder + ": found the results of another study (" + STUDY
                    + " states other values), expected another folder");
        }
        return new SweepFolder(folder, plan);
    }

    /**
     * The folder of a study that has begun. Its bodies and recordings need not be on this machine.
     *
     * @throws BadInputException with one sentence, if there is no study in it
     */
    public static SweepFolder existing(Path folder) {
        Path study = folder.resolve(STUDY);
        if (!Files.isRegularFile(study)) {
            throw new BadInputException(folder + ": found no " + STUDY + ", expected the folder of a study");
        }
        return new SweepFolder(folder, SweepPlan.of(stated(study)));
    }

    private static SweepStudy stated(Path file) {
        return stated(file, TextFile.read(file, "a study"));
    }

    private static SweepStudy stated(Path file, String text) {
        return SweepStudy.parseWithoutBodies(file, text);
    }

    /** A study that cannot be read again cannot be resumed, sharded or merged, which is told before its first run. */
    private static void requireReadable(Path file, String text) {
        try {
            stated(file, text);
        } catch (BadInputException unreadable) {
            throw new BadInputException(
                    file.getParent() + ": found a study that could not be resumed from its " + STUDY + " ("
                            + unreadable.getMessage() + "), expected one with fewer values",
                    unreadable);
        }
    }

    public SweepPlan plan() {
        return plan;
    }

    SweepJournal journal(Shard shard) {
        return new SweepJournal(folder.resolve(shard.journalName()), plan.model(), fingerprint);
    }

    private static List<Path> journals(Path folder) {
        return InputBytes.list(folder).stream()
                .filter(file -> file.getFileName().toString().matches("journal.*\\.csv"))
                .toList();
    }

    /**
     * The runs in all journals of the folder.
     *
     * @throws BadInputException with one sentence, if a journal is of another study or damaged, or if two of its lines
     *     or two journals have different results of the same run
     */
    public SweepResults results() {
        Map<Integer, Recorded> first = new LinkedHashMap<>();
        for (Path journal : journals(folder)) {
            for (RunRow row : SweepJournal.read(journal, plan.model(), fingerprint)) {
                Recorded known = first.putIfAbsent(row.index(), new Recorded(row, journal));
                if (known != null) {
                    known.requireResultOf(row, journal);
                }
            }
        }
        try {
            return new SweepResults(
                    plan, first.values().stream().map(Recorded::row).toList());
        } catch (IllegalArgumentException other) {
            throw new BadInputException(folder + ": " + other.getMessage(), other);
        }
    }

    /** A run and where it is recorded. */
    private record Recorded(RunRow row, Path journal) {
        /** Two failures of a run may be told in different words. */
        void requireResultOf(RunRow other, Path otherJournal) {
            if (!row.hasResultOf(other) && !(row.isFailed() && other.isFailed())) {
                throw new BadInputException(otherJournal + ": found another result of run " + row.index() + " than in "
                        + journal.getFileName() + ", expected the same (a run whose lines are deleted is computed"
                        + " again)");
            }
        }
    }

    /**
     * Writes the results of all journals. A study that ends meanwhile in another process has written its own, which are
     * not left behind older ones.
     */
    public SweepResults merge() {
        return merge(this::results);
    }

    /** @param reads the journals */
    SweepResults merge(Supplier<SweepResults> reads) {
        SweepResults results = reads.get();
        write(results, 0, 0, 1);
        SweepResults after = results.isComplete() ? results : reads.get();
        if (after.done() == results.done() || !after.isComplete()) {
            return results;
        }
        write(after, 0, 0, 1);
        return after;
    }

    /**
     * Writes the results.
     *
     * @param elapsedS time of this process on the study, s
     * @param computed runs that this process computed
     * @param width runs at a time
     */
    public void write(SweepResults results, double elapsedS, int computed, int width) {
        AtomicFile.write(folder.resolve(RUNS), runs(results));
        if (!plan.model().series().isEmpty()) {
            AtomicFile.write(folder.resolve("series.csv"), series(results));
        }
        double leftS = computed == 0 ? 0 : elapsedS / computed * (plan.size() - results.done());
        SweepReport report = new SweepReport(results, leftS, width);
        JsonWriter.write(folder.resolve("study.json"), report.values());
        AtomicFile.write(folder.resolve("report.html"), report.html());
    }

    /** One row a run, in the order of the design. */
    static String runs(SweepResults results) {
        SweepPlan plan = results.plan();
        SweepModel model = plan.model();
        List<String> header = new ArrayList<>(List.of("index"));
        plan.study().factors().forEach(factor -> header.add(factor.key()));
        header.addAll(model.traitNames());
        header.addAll(model.responses());
        header.addAll(List.of("wall_s", "state_sha256", "failure"));
        List<List<String>> rows = new ArrayList<>();
        for (RunRow row : results.rows()) {
            SweepPoint point = plan.points().get(row.index());
            List<String> cells = new ArrayList<>(List.of(String.valueOf(row.index())));
            cells.addAll(point.values());
            cells.addAll(model.traits(point));
            Arrays.stream(row.outcome().responses())
                    .forEach(value -> cells.add(CsvWriter.number(value, CsvWriter.ALL_DIGITS)));
            cells.addAll(List.of(CsvWriter.number(row.wallS(), 4), row.outcome().stateSha256(), row.failure()));
            rows.add(cells);
        }
        return CsvWriter.format(header, rows);
    }

    /** One row a run and time: the share of the run's time, then the observables. */
    private static String series(SweepResults results) {
        List<String> header = new ArrayList<>(List.of("index", "time_percent"));
        header.addAll(results.plan().model().series());
        List<List<String>> rows = new ArrayList<>();
        for (RunRow row : results.rows()) {
            for (int t = 0; t < SweepOutcome.SERIES_POINTS; t++) {
                int at = t;
                double share = (double) PERCENT * t / (SweepOutcome.SERIES_POINTS - 1);
                List<String> cells = new ArrayList<>(
                        List.of(String.valueOf(row.index()), CsvWriter.number(share, CsvWriter.ALL_DIGITS)));
                Arrays.stream(row.outcome().series())
                        .forEach(values -> cells.add(CsvWriter.number(values[at], CsvWriter.ALL_DIGITS)));
                rows.add(cells);
            }
        }
        return CsvWriter.format(header, rows);
    }
}
