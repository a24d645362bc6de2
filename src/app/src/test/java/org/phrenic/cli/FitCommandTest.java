package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.file.FolderLock;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

/** {@code phrenic fit}: what it refuses, in one sentence and before anything is written. */
class FitCommandTest {
    @TempDir
    private Path folder;

    private String mesh;

    @BeforeEach
    void write() {
        Path file = folder.resolve("lung_R.ply");
        MeshFiles.write(file, new TriangleMesh(new double[] {0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9}, new int[] {
            0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3
        }));
        mesh = file.toString();
    }

    private void assertBad(String sentence, String... more) {
        Path out = folder.resolve("out");
        String[] args = new String[more.length + 3];
        args[0] = "fit";
        System.arraycopy(more, 0, args, 1, more.length);
        args[args.length - 2] = "--out";
        args[args.length - 1] = out.toString();
        CommandLineRun run = CommandLineRun.of(args);
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains(sentence).hasLineCount(1);
        assertThat(out).doesNotExist();
    }

    @Test
    void refusesAFolderThatAnotherFitWritesInto() {
        Path busy = folder.resolve("busy");
        try (FolderLock other = FolderLock.of(busy)) {
            String out = other.folder().toString();
            for (String[] args : new String[][] {
                {"fit", "virtual/adult-male", "--resolution", "low", "--target", mesh, "--out", out},
                {"fit", "--synthetic", "1", "--resolution", "low", "--out", out},
                {"bench", "fits", "--random", "1", "--out", out}
            }) {
                CommandLineRun run = CommandLineRun.of(args);
                assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
                assertThat(run.err())
                        .contains("found another run that writes into this folder")
                        .hasLineCount(1);
            }
        }
        assertThat(busy).doesNotExist();
    }

    @Test
    void aScenarioThatDoesNotGiveTheFittedStateIsAFailedCheck() {
        assertThat(FitCommand.exitCode(false)).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(FitCommand.exitCode(true)).isEqualTo(ExitCode.SUCCESS);
    }

    /** A fit writes its landmarks into its folder, in the axes of the body. */
    @Test
    void refusesToWriteOverTheLandmarksThatItReads() throws IOException {
        Path landmarks = Files.writeString(folder.resolve("landmarks.csv"), "the user's own");
        CommandLineRun run = CommandLineRun.of(
                "fit",
                "virtual/adult-male",
                "--target",
                "lung_R=" + mesh,
                "--landmarks",
                landmarks.toString(),
                "--out",
                folder.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("found a file that the command reads").hasLineCount(1);
        assertThat(landmarks).hasContent("the user's own");
    }

    @Test
    void refusesWhatCannotBeFitted() throws IOException {
        String body = "virtual/adult-male";
        assertBad("found no THORAX, expected a body");
        assertBad("found no --target, expected a body", body);
        assertBad("found no folder 'nobody'", "nobody", "--target", mesh);
        assertBad("no such file", body, "--target", "lungs=none.ply");
        assertBad("found part 'spleen', expected PART=FILE with one of lungs,", body, "--target", "spleen=" + mesh);
        assertBad(
                "found an unknown parameter 'muscle_activatoin', did you mean",
                body,
                "--target",
                mesh,
                "--tune",
                "muscle_activatoin");
        assertBad(
                "--target lung_R=" + mesh + ": found its part a second time",
                body,
                "--target",
                mesh,
                "--target",
                "lung_R=" + mesh);
        assertBad("found bounds 1.0 to 0.5", body, "--target", mesh, "--tune", "rib_rotation=1:0.5");
        assertBad("expected 0 to 1.5", body, "--target", mesh, "--tune", "rib_rotation=0:5");
        assertBad("found no number", body, "--target", mesh, "--tune", "rib_rotation=0:x");
        assertBad("that the breath which is held does not use", body, "--target", mesh, "--tune", "rate_per_min");
        assertBad(
                "phrenic: fit: found a scenario whose breath does not use muscle_activation",
                body,
                "--target",
                mesh,
                "--set",
                "material=paper");
        assertBad("found it a second time", body, "--target", mesh, "--tune", "depth,depth");
        assertBad("--hold-out liver: found no such target", body, "--target", mesh, "--hold-out", "liver");
        assertBad("found every target held out", body, "--target", mesh, "--hold-out", "lung_R");
        assertBad("found preset 'sniff', expected preset deep", body, "--target", mesh, "--preset", "sniff");
        assertBad("--evaluations: found 0", body, "--target", mesh, "--evaluations", "0");
        assertBad("phrenic: --resolution lwo: key 'resolution'", "--synthetic", "1", "--resolution", "lwo");
        assertBad("--synthetic: found 6, expected 1 to 5", "--synthetic", "6");
        assertBad("found the body virtual/adult-male beside it", body, "--synthetic", "1");
        assertBad("--target: found it with --synthetic", "--synthetic", "1", "--target", mesh);
        assertBad("--minutes: found it with --synthetic", "--synthetic", "1", "--minutes", "5");
        assertBad("--preset: found it with --synthetic", "--synthetic", "1", "--preset", "quiet");
        assertBad("--made-by: found it without --synthetic", body, "--target", mesh, "--made-by", "me");
        for (String key : new String[] {"anatomy=virtual/adult-female", "steps=3", "duration_s=1", "rate_per_min=9"}) {
            assertBad("found a key that a fit sets itself", body, "--target", mesh, "--set", key);
        }
        Path points = folder.resolve("lungs.csv");
        Files.writeString(points, "x_mm,y_mm,z_mm\n1,2,3\n");
        assertBad("expected a column 'to_x_mm'", body, "--target", points.toString());
    }
}
