package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.ShippedFileException;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.UnreadableException;
import org.phrenic.study.sweep.run.ThreadExecutor;

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

    /** Its one block of LZ4 refers back before its begin. */
    private static final String VTP =
            """
            <?xml version="1.0"?>
            <VTKFile type="PolyData" byte_order="LittleEndian" compressor="vtkLZ4DataCompressor">
            <PolyData><Piece NumberOfPoints="1" NumberOfPolys="0"><Points>
            <DataArray type="Float64" Name="Points" NumberOfComponents="3" format="binary">DATA</DataArray>
            </Points></Piece></PolyData></VTKFile>
            """
                    .replace("DATA", "AQAAABgAAAAAAAAABAAAAA==" + "APAA8A==");

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
        assertThatThrownBy(() -> new ThreadExecutor(1).run(plan, List.of(0), row -> {}))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found no folder '" + body + "'")
                .hasMessageEndingWith("; the runs that are done are kept, and the same command resumes the study");
    }

    /** Wrong content is wrong at every start, and the other bodies are computed. */
    @Test
    void aBodyOfBrokenFilesIsAFailedRun() throws IOException {
        SweepPlan plan = plan("anatomy", "patient, virtual/adult-male");
        Path index = body.resolve("thorax.yaml");
        Files.writeString(index, "structures: [");
        assertThat(first(plan).failure()).contains("found YAML that cannot be read");
        Files.writeString(index, "name: M\u00fcller", StandardCharsets.ISO_8859_1);
        assertThat(first(plan).failure()).contains("found bytes that are not UTF-8");
        Files.writeString(index, "structures: {diaphragm: dome.vtp}");
        assertThat(first(plan).failure()).contains("found no file " + body.resolve("dome.vtp"));
        Files.delete(index);

        Path mesh = body.resolve("diaphragm.vtp");
        Files.writeString(mesh, VTP.substring(0, VTP.length() / 2));
        assertThat(first(plan).failure()).contains(mesh.toString());
        Files.writeString(mesh, VTP);
        assertThat(first(plan).failure()).contains("found compressed data that is damaged, expected LZ4");
        Files.delete(mesh);
        Files.createSymbolicLink(mesh, folder.resolve("moved.vtp"));
        assertThat(first(plan).failure()).contains("found no such file");
    }

    /** The share went away between the index of a body and its meshes. */
    @Test
    void aMissingFileIsWrongOnlyInAFolderThatIsThere() throws IOException {
        Path file = body.resolve("dome.vtp");
        assertThat(InputBytes.missing(file, body, "gone")).isNotInstanceOf(UnreadableException.class);
        Files.delete(body);
        assertThat(InputBytes.missing(file, body, "gone")).isInstanceOf(UnreadableException.class);
        assertThatThrownBy(() -> InputBytes.read(file)).isInstanceOf(UnreadableException.class);
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
        SweepModel torn =
                failing(catchThrowableOfType(ShippedFileException.class, () -> ShippedFile.text("thorax/none.yaml")));
        assertThatThrownBy(() -> RunRow.of(torn, new SweepPoint(0, List.of(), List.of())))
                .hasMessage("data/thorax/none.yaml is missing from the program");
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
