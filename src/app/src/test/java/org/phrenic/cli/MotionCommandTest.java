package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.breathing.pattern.TraceSamples;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.image.VoxelFiles;
import org.phrenic.mesh.io.image.VoxelSeries;
import org.phrenic.mesh.voxel.VoxelBox;

class MotionCommandTest {
    private static final List<String> COARSE = List.of("--resolution", "low", "--set", "mesh_vertices=2000");

    @TempDir
    private Path folder;

    private CommandLineRun motion(String... more) {
        List<String> args = new ArrayList<>(List.of("motion", "--no-organs", "--out"));
        args.add(folder.resolve("out").toString());
        args.addAll(COARSE);
        args.addAll(List.of(more));
        return CommandLineRun.of(args.toArray(new String[0]));
    }

    /** Phases and times are refused before the body is looked for, whose assembly would take longer. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--at 0 | found none of --grid, --points and --warp",
                "--grid 5mm | found 0 of --phases, --at and --times",
                "--grid 5mm --at 0 --phases 3 | found 2 of --phases, --at and --times",
                "--grid 5mm --phases ten --set anatomy=nowhere | --phases: found 'ten'",
                "--grid 5mm --times none.csv --set anatomy=nowhere | none.csv: found no such file",
                "--grid five --at 0 | --grid: found 'five', expected a number",
                "--grid 5mm --labels --at 0 | --labels: found no --warp",
                "--grid 5mm --at 0 --format tif | --format: found 'tif', expected one of nii.gz",
                "--grid 5mm --at 0 --lungs wet | --lungs: found 'wet'"
            })
    void saysInOneSentenceWhatCannotBe(String options, String problem) {
        CommandLineRun run = motion(options.split(" ", -1));
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err().strip()).contains(problem).doesNotContain("\n");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    /** A phase of a series, an image with the name of a written one, and the times count as read. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "warped.nii.gz | --at 0 --warp FILE#0",
                "warped_at_0.000s.nrrd | --at 0 --format nrrd --warp FILE",
                "trajectories.csv | --grid 50 --times FILE"
            })
    void refusesToWriteOverWhatItReads(String name, String options) throws IOException {
        Path input = Files.createDirectory(folder.resolve("out")).resolve(name);
        Files.writeString(input, "the user's");
        CommandLineRun run = motion(options.replace("FILE", input.toString()).split(" ", -1));
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err()).contains(name + ": found a file that the command reads, expected another");
        assertThat(input).hasContent("the user's");
    }

    @Test
    void refusesTimesThatGiveTheSameFiles() {
        CommandLineRun run = motion("--grid", "20mm", "--at", "0.5,0.5004,1");
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err()).contains("found the times 0.5 and 0.5004 s, which give the same files");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    @Test
    void theReportHasTheKeysOfTheDocument() throws IOException {
        Path points = folder.resolve("pairs.csv");
        Files.writeString(points, "x_mm,y_mm,z_mm,to_x_mm,to_y_mm,to_z_mm\n-60,0,0,-60,0,-1\n");
        CommandLineRun run = motion("--points", points.toString(), "--grid", "50", "--jacobian", "--at", "0");
        assertThat(run.exitCode()).as(run.err()).isZero();
        OutputsPage.assertHasKeys("What a motion leaves", folder.resolve("out").resolve("motion.json"));
        assertThat(Files.readString(folder.resolve("out").resolve("trajectories.csv")))
                .startsWith("name,structure,time_s,x_mm,y_mm,z_mm,distance_mm\n");
    }

    /** Files of two motions do not stand under the list of one. */
    @Test
    void aMotionThatFailsLeavesNoListOfAnEarlierOne() throws IOException {
        Path out = Files.createDirectory(folder.resolve("out"));
        Files.createDirectory(out.resolve("trajectories.csv"));
        Path list = Files.writeString(out.resolve("motion.json"), "{}");
        Path points = Files.writeString(folder.resolve("points.csv"), "x_mm,y_mm,z_mm\n-60,0,0\n");
        CommandLineRun late = motion("--points", points.toString(), "--duration", "0.05", "--at", "1");
        assertThat(late.exitCode()).isEqualTo(2);
        assertThat(list).as("what is refused changes nothing").exists();
        CommandLineRun run = motion("--points", points.toString(), "--at", "0");
        assertThat(run.exitCode()).isNotZero();
        assertThat(run.err()).contains("trajectories.csv");
        assertThat(list).doesNotExist();
    }

    @Test
    void refusesAnImageBesideTheBodyAndStructuresThatAreNotThere() throws IOException {
        Path image = folder.resolve("far.nii.gz");
        VoxelBox box = new VoxelBox(new int[] {2, 2, 2}, new double[] {1, 0, 0, 5000, 0, 1, 0, 0, 0, 0, 1, 0});
        VoxelFiles.write(image, VoxelSeries.of(box, 1, ScalarType.INT16, new float[8], Map.of()));
        CommandLineRun far = motion("--warp", image.toString(), "--at", "0");
        assertThat(far.exitCode()).isEqualTo(2);
        assertThat(far.err()).contains("found no voxel inside the body");
        Path bare = folder.resolve("bare.nrrd");
        Files.writeString(
                bare, "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n0 1 0 1 0 1 0 1\n");
        for (String labels : new String[] {"", "--labels "}) {
            CommandLineRun unplaced = motion((labels + "--at 0 --warp " + bare).split(" ", -1));
            assertThat(unplaced.exitCode()).isEqualTo(2);
            assertThat(unplaced.err()).contains("bare.nrrd: found no spacing of its voxels");
        }
        Path points = folder.resolve("points.csv");
        Files.writeString(points, "x_mm,y_mm,z_mm,structure\n0,0,0,lung_X\n");
        CommandLineRun unknown = motion("--points", points.toString(), "--at", "0");
        assertThat(unknown.exitCode()).isEqualTo(2);
        assertThat(unknown.err()).contains("line 2, column 'structure'", "found structure 'lung_X'");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    /** A run ends with the first step at or after its duration, whose time is the last of its table. */
    @Test
    void theTimesOfARunAreThoseOfTheMotionOfTheSameScenario() throws IOException {
        Path run = folder.resolve("run");
        List<String> scenario = new ArrayList<>(COARSE);
        scenario.addAll(List.of("--duration", "0.052"));
        List<String> args = new ArrayList<>(List.of("run", "--out", run.toString()));
        args.addAll(scenario);
        assertThat(CommandLineRun.of(args.toArray(new String[0])).exitCode()).isZero();
        Path points = Files.writeString(folder.resolve("points.csv"), "x_mm,y_mm,z_mm\n-60,0,0\n");
        args = new ArrayList<>(List.of("motion", "--no-organs", "--out"));
        args.addAll(List.of(folder.resolve("out").toString(), "--points", points.toString(), "--times"));
        args.add(run.resolve("observables.csv").toString());
        args.addAll(scenario);
        CommandLineRun motion = CommandLineRun.of(args.toArray(new String[0]));
        assertThat(motion.exitCode()).as(motion.err()).isZero();
        assertThat(Files.readString(folder.resolve("out").resolve("trajectories.csv")))
                .contains(",0.0525,");
    }

    @Test
    void refusesTimesAfterTheLastStep() {
        CommandLineRun run = motion("--grid", "20mm", "--duration", "0.052", "--at", "0.0526");
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err()).contains("--at: found 0.0526 s, expected 0 to 0.0525 s");
    }

    /** Breaths of 4 s, the first of which begins after 1 s of the recording. */
    @Test
    void refusesTheTimesOfTheRecordingWhichAreNotThoseOfTheSimulation() throws IOException {
        String trace = Files.writeString(folder.resolve("trace.csv"), TraceSamples.fromOneSecondOn())
                .toString();
        CommandLineRun run = motion("--grid", "50", "--times", trace, "--set", "trace=" + trace);
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err()).contains("--times " + trace + ": found the recording", "0 is at 1.000 s");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    /** Two steps of 10 ms and 16 of 1.25 ms. */
    @Test
    void theLastTimeAndTheStepsInBetweenAreThoseOfAChangedTimeStep() {
        List<String> changed = List.of("--time-step", "0.01", "--change", "2:time_step_s=0.00125", "--grid", "50");
        CommandLineRun late = motion(with(changed, "--steps", "18", "--at", "0.0413"));
        assertThat(late.exitCode()).isEqualTo(2);
        assertThat(late.err()).contains("--at: found 0.0413 s, expected 0 to 0.04 s");
        CommandLineRun run = motion(with(changed, "--duration", "0.04", "--at", "0,0.0225,0.0245,0.0325", "--json"));
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.out()).contains("\"time_s\": 0.0225,", "\"time_s\": 0.025,", "\"time_s\": 0.0325,");
    }

    private static String[] with(List<String> arguments, String... more) {
        List<String> all = new ArrayList<>(arguments);
        all.addAll(List.of(more));
        return all.toArray(new String[0]);
    }
}
