package org.phrenic.study.sweep.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.file.OutputException;
import org.phrenic.study.sweep.RunMachine;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepOutcome;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.report.SweepReport;

/** What a journal keeps of a study, and of which study. */
class SweepJournalTest {
    private static final ProgressListener SILENT = (count, total, what) -> {};
    private static final String KNOWN =
            """
            title: known
            model: ishigami
            factors:
              - {key: x1, range: [-3, 3]}
              - {key: x2, range: [-3, 3]}
              - {key: x3, range: [-3, 3]}
            design: {kind: latin_hypercube, samples: 4, seed: 1}
            """;
    private static final String BREATHS =
            """
            settings: {resolution: low}
            factors:
              - {key: anatomy, values: [bodies/one, virtual/adult-male]}
            design: {kind: grid}
            responses: [{observable: dome_right_mm, reduction: size}]
            """;

    @TempDir
    private Path folder;

    private static SweepPlan plan(String text) {
        return SweepPlan.of(SweepStudy.parse("study.yaml", text));
    }

    private Path done(String name, SweepPlan plan) {
        Path out = folder.resolve(name);
        assertThat(resumed(out, plan)).isTrue();
        return out;
    }

    private static boolean resumed(Path out, SweepPlan plan) {
        return SweepRunner.run(SweepFolder.of(out, plan), Shard.WHOLE, new ThreadExecutor(1), SILENT)
                .isComplete();
    }

    private static RunRow row(int index, double response) {
        return new RunRow(index, new SweepOutcome(new double[] {response}, "aa", new double[0][]), "", 1, "here");
    }

    /** Its responses would stand beside factor values that they do not belong to. */
    @Test
    void aJournalOfAStudyWithOtherPointsIsRefused() throws IOException {
        Path mine = done("mine", plan(KNOWN));
        Path other = done("other", plan(KNOWN.replace("seed: 1", "seed: 2")));
        Path journal = Files.copy(other.resolve("journal.csv"), mine.resolve("journal-1-of-2.csv"));
        assertThatThrownBy(() -> SweepFolder.existing(mine).results())
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith(
                        journal + ": line 2, column 'plan_fingerprint': found a run of another study (");
    }

    /** A journal without fingerprints has its runs, and goes on as it began. */
    @Test
    void aJournalWithoutFingerprintsIsResumed() throws IOException {
        SweepPlan plan = plan(KNOWN);
        Path out = done("out", plan);
        Path journal = out.resolve("journal.csv");
        List<String> lines = Files.readAllLines(journal).stream()
                .map(line -> line.replaceFirst(",[^,]*(,[^,]*)$", "$1"))
                .toList();
        assertThat(lines.get(0)).endsWith("machine,y");
        Files.writeString(journal, String.join("\n", lines.subList(0, 3)) + "\n");
        assertThat(SweepFolder.of(out, plan).results().done()).isEqualTo(2);
        assertThat(resumed(out, plan)).isTrue();
        assertThat(Files.readAllLines(journal)).hasSize(5).startsWith(lines.get(0), lines.get(1), lines.get(2));
        assertThat(SweepFolder.existing(out).results().isComplete()).isTrue();
    }

    private String fingerprint(String folderName, String study) throws IOException {
        Path place = Files.createDirectories(folder.resolve(folderName));
        for (String body : List.of("one", "two")) {
            Files.createDirectories(place.resolve("bodies").resolve(body));
        }
        Files.writeString(place.resolve("breath.csv"), "time_s,amplitude\n0,0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n7,1\n");
        return SweepPlan.of(SweepStudy.read(Files.writeString(place.resolve("s.yaml"), study)))
                .fingerprint();
    }

    /** Shards on machines that have the bodies in other folders are merged, those of another study are not. */
    @Test
    void aFingerprintTellsStudiesApartAndNotWhereTheirBodiesLie() throws IOException {
        String recorded = BREATHS.replace("low", "low, trace: breath.csv, changes: ['5:trace=breath.csv']");
        assertThat(fingerprint("here", BREATHS)).isEqualTo(fingerprint("there", BREATHS));
        assertThat(fingerprint("here", recorded)).isEqualTo(fingerprint("there", recorded));
        assertThat(fingerprint("here", BREATHS))
                .isEqualTo(fingerprint("here", BREATHS.replace("low", "low, threads: 2")));
        assertThat(List.of(
                        fingerprint("here", BREATHS),
                        fingerprint("here", recorded),
                        fingerprint("here", recorded.replace("5:", "6:")),
                        fingerprint("here", BREATHS.replace("bodies/one", "bodies/two")),
                        fingerprint("here", BREATHS.replace("low", "low, rate_per_min: 20")),
                        fingerprint("here", BREATHS.replace("size", "rise, name: dome_right_mm_size")),
                        fingerprint("here", BREATHS + "series: [dome_right_mm]\n")))
                .doesNotHaveDuplicates();
    }

    /** The one whose file comes first would count. */
    @Test
    void differentResultsOfOneRunAreRefusedAndEqualOnesAreNot() throws IOException {
        SweepFolder study = SweepFolder.of(folder.resolve("out"), plan(KNOWN));
        for (int shard = 0; shard < 2; shard++) {
            try (SweepJournal journal = study.journal(new Shard(shard, 2))) {
                journal.add(row(0, 1.5));
                journal.add(row(2 + shard, 2.5));
            }
        }
        assertThat(study.results().done()).isEqualTo(3);
        try (SweepJournal journal = study.journal(Shard.WHOLE)) {
            journal.add(row(3, Math.nextUp(2.5)));
        }
        assertThatThrownBy(study::results)
                .isInstanceOf(BadInputException.class)
                .hasMessage(folder.resolve("out").resolve("journal.csv") + ": found another result of run 3 than in"
                        + " journal-1-of-2.csv, expected the same (a run whose lines are deleted is computed again)");
    }

    /** A file on a disk that is full once: it takes half of a line. */
    private static final class FullOnce extends RandomAccessFile {
        private boolean isFull;

        FullOnce(Path path) throws IOException {
            super(path.toFile(), "rw");
        }

        @Override
        public void write(byte[] bytes) throws IOException {
            if (isFull) {
                isFull = false;
                super.write(bytes, 0, bytes.length / 2);
                throw new IOException("No space left on device");
            }
            super.write(bytes);
        }
    }

    /** Other threads go on for a while, and their lines are not joined to the half of one. */
    @Test
    void aLineThatIsWrittenInPartLeavesTheOthersReadable() throws IOException {
        SweepPlan plan = plan(KNOWN);
        Path path = folder.resolve("journal.csv");
        try (FullOnce file = new FullOnce(path);
                SweepJournal journal =
                        new SweepJournal(path, file, FileChannel::tryLock, plan.model(), plan.fingerprint())) {
            journal.add(row(0, 1));
            file.isFull = true;
            assertThatThrownBy(() -> journal.add(row(1, 2)))
                    .isInstanceOf(OutputException.class)
                    .hasMessage(path + ": writing failed: No space left on device");
            journal.add(row(2, 3));
        }
        assertThat(SweepJournal.read(path, plan.model(), plan.fingerprint()))
                .extracting(RunRow::index)
                .containsExactly(0, 2);
    }

    /** Shared file systems may have no locks: Lustre without the option flock, NFS without its daemon. */
    @Test
    void aFileSystemWithoutLocksTakesTheRuns() throws IOException {
        SweepPlan plan = plan(KNOWN);
        Path path = folder.resolve("journal.csv");
        SweepJournal.Locking none = channel -> {
            throw new IOException("Function not implemented");
        };
        try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "rw");
                SweepJournal journal = new SweepJournal(path, file, none, plan.model(), plan.fingerprint())) {
            journal.add(row(0, 1));
        }
        assertThat(SweepJournal.read(path, plan.model(), plan.fingerprint())).hasSize(1);
        try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "rw")) {
            assertThatThrownBy(() -> new SweepJournal(path, file, channel -> null, plan.model(), plan.fingerprint()))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("another process writes");
        }
    }

    /** A killed process may leave the half of a line that ends within a letter, as of a processor's name. */
    @Test
    void aLastLineThatEndsWithinALetterIsDropped() throws IOException {
        SweepPlan plan = plan(KNOWN);
        Path out = done("out", plan);
        Path journal = out.resolve("journal.csv");
        byte[] torn = Arrays.copyOf("3,,0.1,aa,K\u00fc".getBytes(StandardCharsets.UTF_8), 12);
        assertThat(torn[11]).isNegative();
        Files.write(journal, torn, StandardOpenOption.APPEND);
        assertThat(SweepFolder.existing(out).results().isComplete()).isTrue();
        assertThat(resumed(out, plan)).isTrue();
    }

    /** A second try would be told that another process writes. */
    @Test
    void aJournalThatIsRefusedIsNotKeptOpen() throws IOException {
        SweepPlan plan = plan(KNOWN);
        Path path = Files.writeString(folder.resolve("journal.csv"), "index,index\n");
        for (int i = 0; i < 2; i++) {
            assertThatThrownBy(() -> new SweepJournal(path, plan.model(), plan.fingerprint()))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("'index'")
                    .hasMessageNotContaining("another process");
        }
    }

    private static final class Notes implements ProgressListener {
        private final List<String> sentences = new ArrayList<>();

        @Override
        public void done(int count, int total, String what) {}

        @Override
        public void note(String sentence) {
            sentences.add(sentence);
        }
    }

    /** Runs of two builds in one table may differ by the build and not by a factor. */
    @Test
    void aStudyThatGoesOnWithAnotherBuildSaysSo() throws IOException {
        SweepPlan plan = plan(KNOWN);
        Path out = done("out", plan);
        Path journal = out.resolve("journal.csv");
        List<String> lines = Files.readAllLines(journal);
        String own = RunMachine.program();
        for (String other : List.of("phrenic 0.1.0", own)) {
            Files.writeString(journal, String.join("\n", lines.subList(0, 3)).replace(own, other) + "\n");
            Notes notes = new Notes();
            SweepFolder study = SweepFolder.of(out, plan);
            SweepRunner.run(study, Shard.WHOLE, new ThreadExecutor(1), notes);
            ReportDocument page = new SweepReport(study.results(), 0, 1).summary(List.of("Commit of the page"));
            String report = Files.readString(out.resolve("report.html"));
            if (other.equals(own)) {
                assertThat(notes.sentences).containsExactly("2 of 4 runs are in the journal");
                assertThat(report).doesNotContain("different builds");
                assertThat(MarkdownPage.format(page)).contains(own).doesNotContain("different builds");
            } else {
                assertThat(notes.sentences)
                        .hasSize(2)
                        .last()
                        .asString()
                        .contains("another build of the program in the journal (phrenic 0.1.0)", "(" + own + ")");
                assertThat(report).contains("different builds of the program");
                assertThat(MarkdownPage.format(page))
                        .contains("different builds of the program", own + "; phrenic 0.1.0.");
            }
        }
    }
}
