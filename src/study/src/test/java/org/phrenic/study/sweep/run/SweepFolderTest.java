package org.phrenic.study.sweep.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.report.StudyCost;

/** What is in the folder of a study, from which another process resumes, shards or merges it. */
class SweepFolderTest {
    @TempDir
    private Path folder;

    /** Points of Ishigami's function in a table, each of three numbers. */
    private SweepPlan list(String point, int count) throws IOException {
        Files.writeString(folder.resolve("points.csv"), "x1,x2,x3\n" + (point + "\n").repeat(count));
        return SweepPlan.of(SweepStudy.read(Files.writeString(
                folder.resolve("list.yaml"), "model: ishigami\ndesign: {kind: list, file: points.csv}\n")));
    }

    /** Beyond the 3 MB that a YAML parser reads unless it is told otherwise. */
    @Test
    void aLongListIsReadAgainByWhoResumesOrMergesIt() throws IOException {
        String digits = "1234567890".repeat(10);
        SweepPlan plan = list("0." + digits + ",1." + digits + ",2." + digits, 12_000);
        Path out = folder.resolve("out");
        SweepFolder.of(out, plan);
        assertThat(out.resolve("study.yaml")).isNotEmptyFile();
        assertThat(Files.size(out.resolve("study.yaml"))).isGreaterThan(3 << 20);
        assertThat(SweepFolder.of(out, plan).plan()).isSameAs(plan);
        assertThat(SweepFolder.existing(out).plan().size()).isEqualTo(plan.size());
    }

    /**
     * Of a study with a key that its model does not read; the runs of hours would be in a folder that nothing reads.
     */
    @Test
    void aStudyThatCouldNotBeReadAgainIsRefusedBeforeItsFirstRun() throws IOException {
        SweepStudy study = list("0,1,2", 4).study();
        SweepPlan plan = SweepPlan.of(new SweepStudy(
                study.title(),
                study.model(),
                study.scenario(),
                study.factors(),
                study.design(),
                List.of(),
                List.of("dome_right_mm")));
        Path out = folder.resolve("out");
        assertThatThrownBy(() -> SweepFolder.of(out, plan))
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith(out + ": found a study that could not be resumed from its study.yaml (")
                .hasMessageContaining("found it with model ishigami, which does not read it")
                .hasMessageEndingWith("), expected one with fewer values");
        assertThat(out).doesNotExist();
    }

    /** Its title is the name of its file, and its paths begin at its folder, as when it is read the first time. */
    @Test
    void aStudyFileMayLieInTheFolderOfItsStudy() throws IOException {
        Path out = Files.createDirectory(folder.resolve("out"));
        Files.writeString(out.resolve("points.csv"), "depth\n0.5\n1\n");
        Files.writeString(out.resolve("calm.yaml"), "resolution: low\n");
        Path file = Files.writeString(
                out.resolve("study.yaml"),
                "scenario: calm.yaml\ndesign: {kind: list, file: points.csv}\n"
                        + "responses: [{observable: dome_right_mm, reduction: size}]\n");
        SweepPlan plan = SweepPlan.of(SweepStudy.read(file));
        assertThat(SweepFolder.of(out, plan).plan()).isSameAs(plan);
        assertThat(SweepFolder.existing(out).plan().study().title()).isEqualTo("study");
    }

    @Test
    void aStudyThatEndsDuringAMergeIsMergedWhole() throws IOException {
        SweepPlan plan = list("0,1,2", 4);
        Path out = folder.resolve("out");
        SweepFolder study = SweepFolder.of(out, plan);
        new ThreadExecutor(1).run(plan, List.of(0, 1, 2), row -> {
            try (SweepJournal journal = study.journal(Shard.WHOLE)) {
                journal.add(row);
            }
        });
        SweepResults merged = study.merge(() -> {
            SweepResults before = study.results();
            SweepRunner.run(study, Shard.WHOLE, new ThreadExecutor(1), (n, of, what) -> {});
            return before;
        });
        assertThat(merged.isComplete()).isTrue();
        assertThat(Files.readAllLines(out.resolve("runs.csv"))).hasSize(5);
        assertThat(Files.readString(out.resolve("study.json"))).contains("\"complete\": true");
    }

    /** The journal of a shard that begins between two looks at the folder is none of an unknown study. */
    @Test
    void shardsThatBeginTogetherTakeTheSameFolder() throws IOException {
        SweepPlan plan = list("0,1,2", 4);
        Path out = Files.createDirectory(folder.resolve("out"));
        SweepFolder second = SweepFolder.of(out, plan, place -> {
            SweepFolder.of(place, plan).journal(new Shard(0, 2)).close();
            return InputBytes.list(place);
        });
        assertThat(second.results().done()).isZero();
        assertThat(out.resolve("journal-0-of-2.csv")).isRegularFile();
    }

    /** A cluster whose machines come while the study runs. */
    private static final class GrowingExecutor implements SweepExecutor {
        private int cores = 2;

        @Override
        public void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done) {
            cores = 24;
            new ThreadExecutor(1).run(plan, pending, done);
        }

        @Override
        public int width() {
            return cores;
        }
    }

    @Test
    void aMeasuredStudyHasTheCoresThatComputedIt() throws IOException {
        StudyCost cost = StudyMeasurement.measure(
                "cluster", folder.resolve("out"), list("0,1,2", 4), new GrowingExecutor(), false, (n, of, what) -> {});
        assertThat(cost.width()).isEqualTo(24);
    }
}
