package org.phrenic.study.sweep.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.file.OutputException;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepOutcome;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.report.SweepReport;

/** A study of Ishigami's function, whose indices are known: whole, killed and resumed, and in shards. */
class SweepRunnerTest {
    private static final ProgressListener SILENT = (count, total, what) -> {};

    @TempDir
    private Path folder;

    private static SweepPlan plan(int samples) {
        String factor = "  - {key: x%d, range: [-3.141592653589793, 3.141592653589793]}\n";
        return SweepPlan.of(SweepStudy.parse(
                "study.yaml",
                "title: known\nmodel: ishigami\nfactors:\n" + factor.formatted(1) + factor.formatted(2)
                        + factor.formatted(3) + "design: {kind: sobol, samples: " + samples + "}\n"));
    }

    private static SweepResults run(SweepPlan plan, Path folder, SweepExecutor executor) {
        return SweepRunner.run(SweepFolder.of(folder, plan), Shard.WHOLE, executor, SILENT);
    }

    /** The table without the column of wall times. */
    private static String withoutTimes(Path folder) throws IOException {
        List<String> kept = new ArrayList<>();
        for (String line : Files.readAllLines(folder.resolve("runs.csv"))) {
            List<String> cells = new ArrayList<>(List.of(line.split(",", -1)));
            cells.remove(5);
            kept.add(String.join(",", cells));
        }
        return String.join("\n", kept);
    }

    /** Windows lets nobody read locked bytes, and shards that begin read the journals of those that run. */
    @Test
    void aJournalThatIsWrittenCanBeRead() throws IOException {
        SweepFolder study = SweepFolder.of(folder, plan(4));
        try (SweepJournal writing = study.journal(Shard.WHOLE);
                FileChannel reading = FileChannel.open(folder.resolve("journal.csv"), StandardOpenOption.WRITE)) {
            assertThat(study.results().done()).isZero();
            assertThat(reading.tryLock(0, 1L << 40, false)).isNotNull();
            assertThatThrownBy(() -> study.journal(Shard.WHOLE))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("another process writes");
        }
    }

    /** Stops as a killed process does: some runs are in the journal, in any order, and half of another's line. */
    private record KilledExecutor(int after) implements SweepExecutor {
        @Override
        public void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done) {
            List<Integer> order = new ArrayList<>(pending.subList(0, after));
            Collections.reverse(order);
            order.forEach(i -> done.accept(RunRow.of(plan.model(), plan.points().get(i))));
            throw new IllegalStateException("killed");
        }

        @Override
        public int width() {
            return 1;
        }
    }

    private static final class CountingExecutor implements SweepExecutor {
        private final List<Integer> asked = new ArrayList<>();

        @Override
        public void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done) {
            asked.addAll(pending);
            new ThreadExecutor(2).run(plan, pending, done);
        }

        @Override
        public int width() {
            return 2;
        }
    }

    /** Indices of Ishigami and Homma 1990 for a = 7, b = 0.1, in closed form. */
    @Test
    void theKnownIndicesOfIshigamisFunctionLieInTheirIntervals() {
        SweepResults results = run(plan(1024), folder, new ThreadExecutor(2));
        Map<?, ?> y =
                (Map<?, ?>) ((Map<?, ?>) new SweepReport(results, 0, 2).values().get("responses")).get("y");
        double[] first = {0.3139, 0.4424, 0};
        double[] total = {0.5576, 0.4424, 0.2437};
        for (int f = 0; f < 3; f++) {
            requireCovered((Map<?, ?>) y.get("first_order"), "x" + (f + 1), first[f]);
            requireCovered((Map<?, ?>) y.get("total"), "x" + (f + 1), total[f]);
        }
        assertThat((double) y.get("mean")).isCloseTo(3.5, within(0.02));
    }

    /** Two samples have values but no interval. */
    @Test
    void aValueWithoutAnIntervalStandsAlone() {
        SweepReport report = new SweepReport(run(plan(2), folder, new ThreadExecutor(1)), 0, 1);
        assertThat(report.sensitivity()).hasSize(3).allSatisfy(row -> assertThat(row.subList(2, 4))
                .allMatch(cell -> cell.matches("-?[0-9.e+-]+")));
        assertThat(report.html()).doesNotContain("NaN");
    }

    private static void requireCovered(Map<?, ?> estimates, String factor, double truth) {
        Map<?, ?> estimate = (Map<?, ?>) estimates.get(factor);
        assertThat(truth).as("index of %s", factor).isBetween((double) estimate.get("low"), (double)
                estimate.get("high"));
        assertThat((double) estimate.get("value")).isCloseTo(truth, within(0.03));
    }

    @Test
    void aStudyKilledAtHalfResumesWithoutRepeatingAndGivesTheSameTable() throws IOException {
        SweepPlan plan = plan(16);
        Path whole = folder.resolve("whole");
        Path killed = folder.resolve("killed");
        run(plan, whole, new ThreadExecutor(1));
        assertThatThrownBy(() -> run(plan, killed, new KilledExecutor(40))).hasMessage("killed");
        Files.writeString(killed.resolve("journal.csv"), "77,,0.1,abc", StandardOpenOption.APPEND);
        CountingExecutor rest = new CountingExecutor();
        SweepResults results = run(plan, killed, rest);
        assertThat(results.isComplete()).isTrue();
        assertThat(rest.asked).hasSize(40).allMatch(i -> i >= 40);
        assertThat(withoutTimes(killed)).isEqualTo(withoutTimes(whole)).hasLineCount(81);
        CountingExecutor nothing = new CountingExecutor();
        run(plan, killed, nothing);
        assertThat(nothing.asked).isEmpty();
    }

    /** A table that another program holds open cannot be replaced; here a folder stands in its place until the end. */
    @Test
    void aTableThatCannotBeWrittenBeforeTheEndIsToldOnceAndTheStudyGoesOn() throws IOException {
        SweepFolder study = SweepFolder.of(folder, plan(16));
        Path table = folder.resolve("runs.csv");
        Path inIt = Files.createDirectories(table).resolve("open");
        Files.createFile(inIt);
        List<String> notes = new ArrayList<>();
        ProgressListener told = new ProgressListener() {
            @Override
            public void done(int count, int total, String what) {}

            @Override
            public void note(String sentence) {
                notes.add(sentence);
            }
        };
        SweepExecutor closingAtTheEnd = new SweepExecutor() {
            @Override
            public void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done) {
                new ThreadExecutor(1).run(plan, pending, done);
                try {
                    Files.delete(inIt);
                    Files.delete(table);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            }

            @Override
            public int width() {
                return 1;
            }
        };
        SweepResults results = SweepRunner.run(study, Shard.WHOLE, closingAtTheEnd, told, 0);
        assertThat(results.isComplete()).isTrue();
        assertThat(notes).singleElement().asString().contains("runs.csv", "the study goes on");
        assertThat(table).isRegularFile();
    }

    @Test
    void aTableThatCannotBeWrittenAtTheEndIsRefused() throws IOException {
        SweepFolder.of(folder, plan(4));
        Files.createFile(Files.createDirectories(folder.resolve("runs.csv")).resolve("open"));
        assertThatThrownBy(() -> run(plan(4), folder, new ThreadExecutor(1)))
                .isInstanceOf(OutputException.class)
                .hasMessageContaining("runs.csv");
    }

    @Test
    void anEmptyJournalIsBegunAndADamagedOneIsRefused() throws IOException {
        SweepPlan plan = plan(4);
        run(plan, folder, new ThreadExecutor(1));
        Path journal = folder.resolve("journal.csv");
        String whole = Files.readString(journal);
        Files.writeString(journal, "");
        assertThat(run(plan, folder, new ThreadExecutor(1)).isComplete()).isTrue();
        int lastDigit = whole.lastIndexOf('\n');
        Files.writeString(journal, whole.substring(0, lastDigit) + "x" + whole.substring(lastDigit));
        assertThatThrownBy(() -> run(plan, folder, new ThreadExecutor(1)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("line 21, column 'y': found '")
                .hasMessageContaining("expected a number");
    }

    @Test
    void journalsOfAnUnknownStudyAreNotTaken() throws IOException {
        run(plan(4), folder, new ThreadExecutor(1));
        Files.delete(folder.resolve("study.yaml"));
        assertThatThrownBy(() -> SweepFolder.of(folder, plan(4)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found journal.csv without study.yaml");
        assertThat(folder.resolve("study.yaml")).doesNotExist();
    }

    @Test
    void shardsInAnyOrderMergeToTheTableOfTheWholeStudy() throws IOException {
        SweepPlan plan = plan(16);
        Path whole = folder.resolve("whole");
        Path shared = folder.resolve("shared");
        run(plan, whole, new ThreadExecutor(2));
        for (String shard : List.of("2/3", "0/3", "1/3")) {
            assertThat(SweepFolder.of(shared, plan).results().isComplete()).isFalse();
            SweepRunner.run(SweepFolder.of(shared, plan), Shard.parse(shard), new ThreadExecutor(1), SILENT);
        }
        SweepFolder merged = SweepFolder.existing(shared);
        assertThat(merged.results().isComplete()).isTrue();
        merged.write(merged.results(), 0, 0, 1);
        assertThat(withoutTimes(shared)).isEqualTo(withoutTimes(whole));
        assertThat(Files.readString(shared.resolve("report.html")))
                .contains("80 of 80 runs", "Not for clinical use.", "data:image/svg+xml");
    }

    private static SweepPlan breaths(int threads) {
        return SweepPlan.of(SweepStudy.parse(
                "study.yaml",
                "settings: {resolution: low, threads: " + threads + "}\nfactors:\n"
                        + "  - {key: sternum, values: [kinematic, kinematic, off]}\n"
                        + "design: {kind: grid}\nresponses: [{observable: dome_right_mm, reduction: size}]\n"));
    }

    /** The default number of threads is the machine's, and a study goes on where another machine left it. */
    @Test
    void aStudyIsTheSameOnMachinesWithOtherNumbersOfProcessors() throws IOException {
        SweepFolder.of(folder, breaths(2));
        assertThat(SweepFolder.of(folder, breaths(4)).plan().size()).isEqualTo(3);
        Path study = folder.resolve("study.yaml");
        Files.writeString(study, Files.readString(study).replace("settings:", "settings:\n  threads: 8"));
        assertThat(SweepFolder.of(folder, breaths(4)).plan().size()).isEqualTo(3);
    }

    /** A value listed twice has one place on the axis, and each value its own name there. */
    @Test
    void curvesNameEachListedValueOnce() {
        SweepPlan plan = breaths(1);
        List<RunRow> rows = new ArrayList<>();
        for (int run = 0; run < 3; run++) {
            SweepOutcome outcome = new SweepOutcome(new double[] {10 + run}, "aa", new double[0][]);
            rows.add(new RunRow(run, outcome, "", 1, "here"));
        }
        List<String> curves = Pattern.compile("svg\\+xml;base64,([^\"]+)\"")
                .matcher(new SweepReport(new SweepResults(plan, rows), 0, 1).html())
                .results()
                .map(image -> new String(Base64.getDecoder().decode(image.group(1)), StandardCharsets.UTF_8))
                .filter(image -> image.contains(">off</text>"))
                .toList();
        assertThat(curves).singleElement().asString().containsOnlyOnce(">kinematic</text>");
    }

    @Test
    void aFolderOfAnotherStudyIsRefused() {
        run(plan(4), folder, new ThreadExecutor(1));
        assertThatThrownBy(() -> SweepFolder.of(folder, plan(8)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("another study");
        assertThatThrownBy(() -> SweepFolder.existing(folder.resolve("none")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("expected the folder of a study");
        assertThatThrownBy(() -> Shard.parse("3/3")).hasMessageContaining("found '3/3', expected k/n");
    }

    @Test
    void aRunWithAnotherHashResponseOrSeriesIsNotTheSame() {
        SweepOutcome outcome = new SweepOutcome(new double[] {1}, "aa", new double[][] {{1, 2}});
        RunRow row = new RunRow(0, outcome, "", 1, "here");
        assertThat(row.hasResultOf(new RunRow(0, outcome, "", 2, "there"))).isTrue();
        for (SweepOutcome other : List.of(
                new SweepOutcome(new double[] {Math.nextUp(1.0)}, "aa", new double[][] {{1, 2}}),
                new SweepOutcome(new double[] {1}, "ab", new double[][] {{1, 2}}),
                new SweepOutcome(new double[] {1}, "aa", new double[][] {{1, 3}}))) {
            assertThat(row.hasResultOf(new RunRow(0, other, "", 1, "here"))).isFalse();
        }
        assertThat(row.hasResultOf(new RunRow(1, outcome, "", 1, "here"))).isFalse();
        assertThat(row.hasResultOf(new RunRow(0, outcome, "diverged", 1, "here")))
                .isFalse();
    }

    /** A merge evaluates nothing: the bodies and recordings may be on the machines of the shards alone. */
    @Test
    void aMergeNeedsNeitherBodiesNorRecordings() throws IOException {
        Path shared = folder.resolve("shared");
        Path near = Files.createDirectory(folder.resolve("near"));
        Path far = Files.createDirectory(folder.resolve("far"));
        Path breath = Files.writeString(
                folder.resolve("breath.csv"), "time_s,amplitude\n0,0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n7,1\n8,0\n");
        Path file = Files.writeString(
                folder.resolve("s.yaml"),
                "settings: {anatomy: near, trace: breath.csv, resolution: low, preset: hold-inspiration}\nfactors:\n"
                        + "  - {key: anatomy, values: [far, virtual/adult-male]}\n"
                        + "  - {key: trace, values: [breath.csv, none]}\n"
                        + "design: {kind: grid}\nresponses: [{observable: dome_right_mm, reduction: creep}]\n");
        SweepPlan plan = SweepPlan.of(SweepStudy.read(file));
        try (SweepJournal journal = SweepFolder.of(shared, plan).journal(Shard.WHOLE)) {
            for (int run = 0; run < plan.size(); run++) {
                SweepOutcome outcome = new SweepOutcome(new double[] {10 + run}, "aa", new double[0][]);
                journal.add(new RunRow(run, outcome, "", 1, "there"));
            }
        }
        for (Path gone : List.of(near, far, breath)) {
            Files.delete(gone);
        }
        SweepFolder merged = SweepFolder.existing(shared);
        assertThat(merged.plan().study().resolved()).isEqualTo(plan.study().resolved());
        assertThat(merged.results().isComplete()).isTrue();
        merged.write(merged.results(), 0, 0, 1);
        assertThat(Files.readString(shared.resolve("runs.csv"))).contains(far.toString(), breath.toString());
        Path study = shared.resolve("study.yaml");
        Files.writeString(study, Files.readString(study).replace("preset: hold-inspiration", "preset: held"));
        assertThatThrownBy(() -> SweepFolder.existing(shared))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("'held'");
    }
}
