package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.SonatedNeedle;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.cli.option.ProbeOptions;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import picocli.CommandLine;

@Execution(ExecutionMode.CONCURRENT)
class UltrasoundCommandTest {
    @TempDir
    Path folder;

    private CommandLineRun ultrasound(String out, String... more) {
        List<String> args =
                new ArrayList<>(List.of("ultrasound", "--resolution", "low", "--set", "mesh_vertices=2000"));
        args.addAll(List.of("--set", "lungs=embedded", "--set", "sternum=kinematic"));
        args.addAll(List.of("--preset", "rapid-shallow", "--set", "rate_per_min=70", "--duration", "0.9"));
        args.addAll(List.of("--out", folder.resolve(out).toString()));
        args.addAll(List.of(more));
        return CommandLineRun.of(args.toArray(new String[0]));
    }

    @Test
    void imagesFollowTheBreathAndAreTheSameOnAnyNumberOfThreads() throws IOException {
        String[] needle = {"--at", "0,0.35", "--needle", "-160,-15,21,-100,-15,21"};
        CommandLineRun one = ultrasound("one", concatenate(needle, "--threads", "1"));
        CommandLineRun two = ultrasound("two", concatenate(needle, "--threads", "2"));
        assertThat(one.exitCode()).as(one.err()).isZero();
        assertThat(two.exitCode()).as(two.err()).isZero();
        assertThat(one.out()).contains("ultrasound_0002.png", "Not for clinical use");
        assertThat(one.err()).doesNotContain("pleura");
        for (String name : List.of("ultrasound_0001.png", "ultrasound_0002.png", "ultrasound.json")) {
            assertThat(Files.readAllBytes(folder.resolve("one").resolve(name)))
                    .isEqualTo(Files.readAllBytes(folder.resolve("two").resolve(name)));
        }
        assertThat(Files.readAllBytes(folder.resolve("one/ultrasound_0001.png")))
                .isNotEqualTo(Files.readAllBytes(folder.resolve("one/ultrasound_0002.png")));
        assertThat(Files.readString(folder.resolve("one/ultrasound.json")))
                .contains("\"face_mm\"", "\"needle_in_beam_mm\"", "\"tip_in_beam\"", "Not for clinical use");
    }

    /** As a vessel that a scan cuts off on all sides; the pleura, which no image shows, is passed over. */
    @Test
    void aStructureThatIsTooOpenIsNamed() throws IOException {
        Path body = Files.createDirectory(folder.resolve("body"));
        Thorax man = VirtualThorax.ofPreset("adult-male", new MeshBudget(2000));
        for (Structure s : man.structures()) {
            MeshFiles.write(body.resolve(s.name() + ".ply"), s.mesh());
        }
        TriangleMesh liver = man.find("liver").orElseThrow().mesh();
        MeshFiles.write(
                body.resolve("vessel_open.ply"),
                new TriangleMesh(liver.positions(), Arrays.copyOf(liver.triangles(), 300)));
        CommandLineRun run = ultrasound("open", "--anatomy", body.toString());
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.err()).contains("Not in the images, as they are open: vessel_open.");
        assertThat(Files.readString(folder.resolve("open/ultrasound.json"))).contains("\"left_out\": [");
    }

    @Test
    void eachOptionSetsWhatItIsNamedAfter() {
        ProbeOptions options = new ProbeOptions();
        new CommandLine(options)
                .parseArgs(("--rotate 1 --tilt 2 --rock 3 --frequency 2.5 --focus 60 --thickness 4 --depth 120 --gain 5"
                                + " --depth-gain 0.7 --dynamic-range 50 --needle 1,2,3,4,5,60")
                        .split(" "));
        assertThat(options.angles()).isEqualTo(new ProbePose.Angles(1, 2, 3));
        CurvilinearProbe usual = CurvilinearProbe.abdominal();
        assertThat(options.probe()).isEqualTo(new CurvilinearProbe(usual.radiusMm(), usual.sectorDeg(), 2.5, 60, 4));
        assertThat(options.settings()).isEqualTo(new UltrasoundSettings(120, 5, 0.7, 50));
        SonatedNeedle needle = options.needle().orElseThrow();
        assertThat(needle.entry()).containsExactly(1, 2, 3);
        assertThat(needle.tip()).containsExactly(4, 5, 60);
    }

    private static String[] concatenate(String[] some, String... others) {
        List<String> all = new ArrayList<>(List.of(some));
        all.addAll(List.of(others));
        return all.toArray(new String[0]);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--skin | the-back | expected X,Y,Z in mm or one of right-intercostal",
                "--skin | 1,2 | found 2 numbers",
                "--skin | 0,0,0 | inside the body, expected a place on the skin",
                "--depth | 10 | expected 40 to 300",
                "--frequency | 9 | expected 2 to 5",
                "--tilt | steep | expected a number",
                "--movie | a.gif | found an unknown option '--movie'",
                "--at | 7 | expected 0 to 0.9 s"
            })
    void whatCannotBeSonatedIsRefusedInOneSentence(String option, String value, String sentence) {
        CommandLineRun run = ultrasound("bad", option, value);
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err()).contains(sentence);
        assertThat(folder.resolve("bad")).doesNotExist();
    }
}
