package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;

/** What is a failed run for good, and what ends the study, which goes on from there later. */
class RunRowTest {
    private static final String STUDY =
            """
            settings: {resolution: low}
            factors:
              - {key: KEY, values: [VALUES]}
            design: {kind: grid}
            responses: [{observable: dome_right_mm, reduction: size}]
            """;

    @TempDir
    private Path folder;

    private Path body;
    private Path trace;

    @BeforeEach
    void write() throws IOException {
        body = Files.createDirectories(folder.resolve("patient"));
        trace = Files.writeString(
                folder.resolve("breath.csv"), "time_s,amplitude\n0,0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n7,1\n");
    }

    private SweepPlan plan(String key, String values) throws IOException {
        String text = STUDY.replace("KEY", key).replace("VALUES", values);
        return SweepPlan.of(SweepStudy.read(Files.writeString(folder.resolve("study.yaml"), text)));
    }

    private static RunRow first(SweepPlan plan) {
        return RunRow.of(plan.model(), plan.points().get(0));
    }

    /** The folder of a network may be away for a moment, in which every run that is left would fail. */
    @Test
    void aBodyThatIsAwayEndsTheStudy() throws IOException {
        SweepPlan plan = plan("anatomy", "patient, virtual/adult-male");
        RunRow withoutMeshes = first(plan);
        assertThat(withoutMeshes.failure()).contains("no mesh has the name of a structure");
        Files.delete(body);
        assertThatThrownBy(() -> first(plan))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found no folder '" + body + "'");
    }

    @Test
    void aRecordingThatIsAwayEndsTheStudy() throws IOException {
        SweepPlan plan = plan("trace", "breath.csv");
        Files.delete(trace);
        assertThatThrownBy(() -> first(plan))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("breath.csv");
    }

    /** The program may be replaced under a study that runs. */
    @Test
    void dataThatCannotBeReadEndTheStudy() {
        assertThatThrownBy(() -> RunRow.of(
                        failing(new UncheckedIOException(new IOException("stale file handle"))),
                        new SweepPoint(0, List.of(), List.of())))
                .isInstanceOf(UncheckedIOException.class);
        assertThat(RunRow.of(failing(new IllegalStateException("torn")), new SweepPoint(0, List.of(), List.of()))
                        .failure())
                .isEqualTo("torn");
    }

    private static SweepModel failing(RuntimeException failure) {
        return new SweepModel() {
            @Override
            public List<String> responses() {
                return List.of("y");
            }

            @Override
            public List<String> series() {
                return List.of();
            }

            @Override
            public double[] limits(String key) {
                return new double[0];
            }

            @Override
            public void check(String key, String value) {
                throw failure;
            }

            @Override
            public SweepOutcome evaluate(SweepPoint point) {
                throw failure;
            }
        };
    }
}
