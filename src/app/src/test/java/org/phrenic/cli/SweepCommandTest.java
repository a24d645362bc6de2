package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepStudy;
import picocli.CommandLine;

/** The command line of studies. */
class SweepCommandTest {
    private static final Path STUDIES = Path.of("data/studies");

    @TempDir
    private Path folder;

    private Path study() throws IOException {
        String small = Files.readString(STUDIES.resolve("ishigami.yaml")).replace("1024", "8");
        return Files.writeString(folder.resolve("study.yaml"), small);
    }

    @Test
    void aStudyIsPrintedAndWrittenAndResumes() throws IOException {
        Path out = folder.resolve("out");
        CommandLineRun run = CommandLineRun.of("sweep", study().toString(), "--out", out.toString(), "--threads", "2");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.out()).contains("first order", "40 of 40 runs are done, 0 failed", "Not for clinical use.");
        assertThat(Files.readAllLines(out.resolve("runs.csv"))).hasSize(41);
        assertThat(Files.readString(out.resolve("report.html"))).contains("40 of 40", "Not for clinical use.");
        CommandLineRun again = CommandLineRun.of("sweep", study().toString(), "--out", out.toString(), "--json");
        assertThat(again.err()).contains("40 of 40 runs are in the journal");
        assertThat(again.out()).contains("\"complete\": true", "\"first_order\"");
    }

    @Test
    void aStudyThatRunsAlreadyIsRefused() throws IOException {
        Path out = folder.resolve("out");
        String[] args = {"sweep", study().toString(), "--out", out.toString()};
        assertThat(CommandLineRun.of(args).exitCode()).isZero();
        try (FileChannel journal = FileChannel.open(out.resolve("journal.csv"), StandardOpenOption.WRITE);
                FileLock other = journal.lock()) {
            assertThat(other.isValid()).isTrue();
            CommandLineRun second = CommandLineRun.of(args);
            assertThat(second.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(second.err()).contains("the study runs already").hasLineCount(1);
        }
    }

    @Test
    void aPageHasIndicesProvenanceAndPicturesBesideIt() throws IOException {
        Path page = folder.resolve("found.md");
        String out = folder.resolve("out").toString();
        CommandLineRun run = CommandLineRun.of(
                "sweep", study().toString(), "--out", out, "--page", page.toString(), "--made-by", "Commit 1234567");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(Files.readString(page))
                .contains(
                        "- Commit 1234567\n- With: phrenic sweep ",
                        " --out out\n",
                        "total \\[95 %\\]",
                        "(found-1.svg)",
                        "| x1 |");
        assertThat(Files.readString(folder.resolve("found-1.svg")))
                .startsWith("<svg ")
                .contains(">x1</text>")
                .endsWith("</svg>\n");
    }

    @Test
    void aMergeOfAnUnfinishedStudySaysHowManyRunsAreMissing() throws IOException {
        Path out = folder.resolve("out");
        String file = study().toString();
        assertThat(CommandLineRun.of("sweep", file, "--out", out.toString(), "--shard", "1/4")
                        .exitCode())
                .isZero();
        CommandLineRun merge = CommandLineRun.of("sweep", "--merge", out.toString());
        assertThat(merge.exitCode()).isEqualTo(ExitCode.FAILURE);
        assertThat(merge.err()).contains("30 runs are missing");
        assertThat(Files.readAllLines(out.resolve("runs.csv"))).hasSize(11);
    }

    /** Shards that begin together find no runs of each other. */
    @Test
    void aMergeOfTwoBuildsSaysSo() throws IOException {
        Path out = folder.resolve("out");
        for (String shard : List.of("0/2", "1/2")) {
            CommandLineRun.of("sweep", study().toString(), "--out", out.toString(), "--shard", shard);
        }
        Path journal = out.resolve("journal-1-of-2.csv");
        Files.writeString(journal, Files.readString(journal).replace("phrenic ", "phrenic 0.0.1 "));
        CommandLineRun merge = CommandLineRun.of("sweep", "--merge", out.toString());
        assertThat(merge.exitCode()).isZero();
        assertThat(merge.err()).contains("phrenic: The runs are of different builds of the program", "phrenic 0.0.1 ");
    }

    @Test
    void aResumedStudyOfTwoBuildsSaysSoOnce() throws IOException {
        Path out = folder.resolve("out");
        String file = study().toString();
        CommandLineRun.of("sweep", file, "--out", out.toString());
        Path journal = out.resolve("journal.csv");
        List<String> lines = Files.readAllLines(journal);
        Files.writeString(
                journal,
                String.join("\n", lines.subList(0, lines.size() - 1)).replace("phrenic ", "phrenic 0.0.1 ") + "\n");
        CommandLineRun again = CommandLineRun.of("sweep", file, "--out", out.toString());
        assertThat(again.exitCode()).isZero();
        assertThat(again.err()).containsOnlyOnce("phrenic 0.0.1 ").contains("another build of the program");
    }

    /** A study of fewer runs than shards, as in an array of jobs of fixed size. */
    @Test
    void aShardWithoutRunsSucceeds() throws IOException {
        String file = study().toString();
        CommandLineRun run =
                CommandLineRun.of("sweep", file, "--out", folder.resolve("out").toString(), "--shard", "50/100");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.out()).contains("0 of 40 runs are done, 0 failed");
    }

    @Test
    void keysThatAStudyDoesNotReadAreRefused() throws IOException {
        String ranges = "model: ishigami\nfactors:\n- {key: x1, range: [0, 1]}\n- {key: x2, range: [0, 1]}\n"
                + "- {key: x3, range: [0, 1]}\n";
        String listed = "factors:\n- {key: depth, values: [0.5, 1], levels: 3}\ndesign: {kind: grid}\n";
        for (List<String> bad : List.of(
                List.of(ranges + "design: {kind: grid, levels: 2}\n", "expected it at the factors"),
                List.of(ranges + "design: {kind: grid, samples: 7}\n", "found it in a design of kind grid"),
                List.of(ranges + "design: {kind: sobol, samples: 8, levels: 4}\n", "kind sobol"),
                List.of(
                        ranges.replace("1]}\n- {key: x2", "1], levels: 8}\n- {key: x2")
                                + "design: {kind: morris, samples: 4}\n",
                        "expected it at ranges in a grid"),
                List.of(listed, "found it with listed values"),
                List.of(ranges + "design: {kind: grid}\nseries: [air_ml]\n", "with model ishigami"),
                List.of(ranges + "design: {kind: grid}\nsettings: {depth: 1}\n", "which does not read it"))) {
            Path file = Files.writeString(folder.resolve("bad.yaml"), bad.get(0));
            CommandLineRun run = CommandLineRun.of(
                    "sweep", file.toString(), "--out", folder.resolve("out").toString());
            assertThat(run.exitCode()).as(bad.get(0)).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.err()).contains(bad.get(1)).hasLineCount(1);
        }
    }

    /** The list of a study is {@code runs.csv} in the folder of its results. */
    @Test
    void resultsAreNotWrittenOverAListOfPoints() throws IOException {
        Path list = Files.writeString(folder.resolve("runs.csv"), "x1,x2,x3\n0,1,2\n");
        Path file = Files.writeString(
                folder.resolve("listed.yaml"), "model: ishigami\ndesign: {kind: list, file: runs.csv}\n");
        CommandLineRun run = CommandLineRun.of("sweep", file.toString(), "--out", folder.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("which would be written over").hasLineCount(1);
        assertThat(list).hasContent("x1,x2,x3\n0,1,2");
    }

    @Test
    void whatIsMissingOrContradictsIsBadInput() throws IOException {
        String file = study().toString();
        String out = folder.resolve("out").toString();
        for (List<String> args : List.of(
                List.of("sweep"),
                List.of("sweep", file),
                List.of("sweep", "--merge", out),
                List.of("sweep", file, "--merge", out),
                List.of("sweep", file, "--out", out, "--shard", "4/4"),
                List.of("sweep", file, "--out", out, "--shard", "0/4", "--page", out + ".md"),
                List.of("sweep", file, "--out", out, "--shard", "1/2", "--master", "local[1]"),
                List.of("sweep", file, "--out", out, "--made-by", "me"),
                List.of("sweep", file, "--out", out, "--page", file + "/found.md"),
                List.of("sweep", file, "--out", out, "--page", file),
                List.of("sweep", file, "--out", out, "--page", out + "/journal.csv"),
                List.of("sweep", folder.resolve("none.yaml").toString(), "--out", out))) {
            CommandLineRun run = CommandLineRun.of(args.toArray(String[]::new));
            assertThat(run.exitCode()).as(args.toString()).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.err().strip())
                    .startsWith("phrenic: ")
                    .hasLineCount(1)
                    .contains("expected");
        }
        assertThat(folder.resolve("out")).doesNotExist();
    }

    @Test
    void aPageIsNotWrittenOverTheStudy() throws IOException {
        Path file = Files.copy(study(), folder.resolve("study.md"));
        String content = Files.readString(file);
        CommandLineRun run = CommandLineRun.of(
                "sweep", file.toString(), "--out", folder.resolve("out").toString(), "--page", file.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("a file that the command reads").hasLineCount(1);
        assertThat(file).content().isEqualTo(content);
        assertThat(folder.resolve("out")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource({
        "ishigami, 5120",
        "small, 16",
        "liver-motion, 128",
        "liver-shares, 512",
        "cohort, 1000",
        "access, 200",
        "load, 48",
        "persons, 12"
    })
    void theStudiesThatComeWithTheProgramHavePlans(String name, int runs) {
        SweepPlan plan = SweepPlan.of(SweepStudy.read(STUDIES.resolve(name + ".yaml")));
        assertThat(plan.size()).isEqualTo(runs);
    }

    @Test
    void theDriverOfAClusterReceivesAllOptionsButTheMaster() {
        SweepCommand command = new SweepCommand();
        new CommandLine(command)
                .parseArgs(
                        "study.yaml",
                        "--out",
                        "x",
                        "--master",
                        "local[2]",
                        "--page",
                        "p.md",
                        "--made-by",
                        "Commit 1",
                        "--json");
        assertThat(command.argumentsWithoutMaster())
                .containsExactly(
                        "sweep", "study.yaml", "--out", "x", "--page", "p.md", "--made-by", "Commit 1", "--json");
    }

    @Test
    void aStudyCostsItsWaysTheSameRows() throws IOException {
        Path out = folder.resolve("ways");
        String[] ways = {
            "bench", "studies", study().toString(), "--threads", "1,2", "--shards", "3", "--out", out.toString()
        };
        CommandLineRun run = CommandLineRun.of(ways);
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(Files.readString(out.resolve("studies.md")))
                .contains(
                        "| 1 thread |",
                        "| 2 threads |",
                        "| 3 shards, merged |",
                        "all rows, hashes and series are equal")
                .doesNotContain("| no |");
        assertThat(CommandLineRun.of(ways).err()).contains("of an earlier run").hasLineCount(1);
        ways[4] = "2,2";
        ways[8] = folder.resolve("twice").toString();
        assertThat(CommandLineRun.of(ways).err()).contains("found two ways").hasLineCount(1);
        assertThat(folder.resolve("twice")).doesNotExist();
    }
}
