package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.document.CsvTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

/** {@code phrenic compare} on two boxes, one 2 mm higher than the other. */
class CompareCommandTest {
    @TempDir
    private Path folder;

    private String low;
    private String high;

    @BeforeEach
    void write() {
        low = box("low.ply", 10);
        high = box("high.stl", 12);
    }

    private String box(String name, double height) {
        double[] p = new double[24];
        for (int i = 0; i < 8; i++) {
            p[3 * i] = (i & 1) == 0 ? 0 : 20;
            p[3 * i + 1] = (i & 2) == 0 ? 0 : 15;
            p[3 * i + 2] = (i & 4) == 0 ? 0 : height;
        }
        int[] t = {
            0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5
        };
        Path file = folder.resolve(name);
        MeshFiles.write(file, new TriangleMesh(p, t));
        return file.toString();
    }

    @Test
    void theTableSaysBothDirections() {
        CommandLineRun run = CommandLineRun.of("compare", high, low);
        assertThat(run.exitCode()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out())
                .containsPattern("A to B +vertex +8 +1\\.000 +1\\.000 +1\\.414 +0\\.000 +2\\.000 +2\\.000")
                .containsPattern("A to B[^\\n]*\\n +area[^\\n]* \\+1\\.000")
                .contains("Hausdorff distance 2.000 mm")
                .contains(Disclaimer.TEXT);
        assertThat(run.err()).isEmpty();
    }

    @Test
    void jsonCsvAndPlyHoldWhatTheTableSays() {
        Path csv = folder.resolve("d.csv");
        Path ply = folder.resolve("d.ply");
        CommandLineRun run =
                CommandLineRun.of("compare", high, low, "--json", "--csv", csv.toString(), "--ply", ply.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out()).contains("\"hausdorff_mm\": 2.0", "\"signed_mean_mm\": 1.0", "\"symmetric\"");
        CsvTable table = CsvTable.read(csv);
        assertThat(table.columnNames()).startsWith("x_mm", "y_mm", "z_mm", "area_mm2", "distance_mm");
        double[] z = table.numbers("z_mm");
        double[] distance = table.numbers("distance_mm");
        for (int i = 0; i < z.length; i++) {
            assertThat(distance[i]).isEqualTo(z[i] == 0 ? 0 : 2);
        }
        assertThat(MeshFiles.read(ply).vertexCount()).isEqualTo(8);
    }

    @Test
    void aPictureIsDrawnOrTheCommandSaysThatNothingHereDraws() {
        Path picture = folder.resolve("map.png");
        CommandLineRun run = CommandLineRun.of(
                "compare", low, high, "--picture", picture.toString(), "--size", "64x64", "--range", "-2:2");
        assertThat(run.exitCode()).as(run.err()).isEqualTo(DrawingHere.exitCode());
        assertThat(Files.exists(picture)).isEqualTo(run.exitCode() == ExitCode.SUCCESS);
    }

    @Test
    void whatCannotBeComparedIsToldInOneSentence() {
        assertBad("no such file", "compare", low, folder.resolve("none.ply").toString());
        assertBad("expected one of", "compare", low, folder.resolve("x.txt").toString());
        assertBad("--picture x.jpg: found another ending", "compare", low, high, "--picture", "x.jpg");
        assertBad("--csv ", "compare", low, high, "--csv", low + "/x.csv");
        String root = folder.getRoot().toString();
        assertBad("--csv " + root + ": found ", "compare", low, high, "--csv", root);
        assertBad("--csv " + low + ": found a file that the command reads", "compare", low, high, "--csv", low);
        assertBad("--ply " + high + ": found a file that the command reads", "compare", low, high, "--ply", high);
        assertBad("found it for another output too", "compare", low, high, "--csv", "x.csv", "--ply", "./x.csv");
        assertBad("--range: found it without --picture", "compare", low, high, "--range", "0:5");
        assertBad("--zoom: found it without --picture", "compare", low, high, "--zoom", "2");
        assertBad(
                "expected a folder",
                "compare",
                low,
                high,
                "--csv",
                Path.of(low, "sub", "d.csv").toString());
    }

    private static void assertBad(String part, String... args) {
        CommandLineRun run = CommandLineRun.of(args);
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err().strip()).contains(part).doesNotContain("\n");
        assertThat(run.out()).isEmpty();
    }
}
