package org.phrenic.cluster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.Phrenic;
import org.phrenic.file.OutputException;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.run.SweepExecutor;

/** The same study gives the same rows on threads, on local Spark and on executors of which one is killed. */
class SparkStudyTest {
    private static final String CLASS_PATH =
            System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    private static final int PATIENCE_S = 420;

    private static final String BREATHS =
            """
            settings: {resolution: low, duration_s: 0.04}
            design: {kind: list, columns: [depth, material], points: [[1.2, physical], [0.9, paper]]}
            responses:
              - {observable: liver_si_mm, reduction: size}
            series: [dome_right_mm]
            """;

    private static final String KNOWN =
            """
            model: ishigami
            factors:
              - {key: x1, range: [-3.14159, 3.14159]}
              - {key: x2, range: [-3.14159, 3.14159]}
              - {key: x3, range: [-3.14159, 3.14159]}
            design: {kind: sobol, samples: 2048}
            """;

    @TempDir
    private Path folder;

    private Path home;

    /** Local executors want a folder of Spark; what they load comes from their class path. */
    @BeforeEach
    void makeHome() throws IOException {
        home = Files.createDirectories(folder.resolve("spark"));
        Files.createDirectories(home.resolve("jars"));
        Files.createFile(home.resolve("RELEASE"));
    }

    private Path study(String text) throws IOException {
        return Files.writeString(folder.resolve("study.yaml"), text);
    }

    private String onThreads(Path study) throws IOException {
        Path out = folder.resolve("threads");
        StringWriter err = new StringWriter();
        int code = Phrenic.execute(
                new PrintWriter(new StringWriter()),
                new PrintWriter(err),
                "sweep",
                study.toString(),
                "--out",
                out.toString(),
                "--threads",
                "2");
        assertThat(code).as(err.toString()).isZero();
        return withoutTimes(out);
    }

    private Process onSpark(Path study, Path out, String master) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx600m",
                "-XX:TieredStopAtLevel=1",
                "-Djava.awt.headless=true",
                "-Dspark.master=" + master,
                "-Dspark.driver.host=127.0.0.1",
                "-Dspark.executor.extraClassPath=" + CLASS_PATH,
                "-Dspark.executor.extraJavaOptions=-XX:TieredStopAtLevel=1",
                "-cp",
                CLASS_PATH,
                ClusterMain.class.getName(),
                "sweep",
                study.toString(),
                "--out",
                out.toString()));
        ProcessBuilder builder = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("log").toFile());
        builder.environment().put("SPARK_HOME", home.toString());
        builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
        builder.environment().put("SPARK_SCALA_VERSION", "2.13");
        return builder.start();
    }

    private void requireDone(Process process) throws Exception {
        boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        String log = Files.readString(folder.resolve("log"), StandardCharsets.UTF_8);
        assertThat(ended).as(log).isTrue();
        assertThat(process.exitValue()).as(log).isZero();
    }

    private static String withoutTimes(Path out) throws IOException {
        List<String> lines = Files.readAllLines(out.resolve("runs.csv"));
        int wall = List.of(lines.get(0).split(",", -1)).indexOf("wall_s");
        List<String> kept = new ArrayList<>();
        for (String line : lines) {
            List<String> cells = new ArrayList<>(List.of(line.split(",", -1)));
            cells.remove(wall);
            kept.add(String.join(",", cells));
        }
        return String.join("\n", kept);
    }

    @Test
    void localSparkGivesTheRowsOfThreads() throws Exception {
        Path study = study(BREATHS);
        Path out = folder.resolve("out");
        Process spark = onSpark(study, out, "local[2]");
        String expected = onThreads(study);
        requireDone(spark);
        assertThat(withoutTimes(out)).isEqualTo(expected).hasLineCount(3);
        assertThat(Files.readString(out.resolve("series.csv")))
                .isEqualTo(Files.readString(folder.resolve("threads").resolve("series.csv")));
    }

    @Test
    void aStudyWhoseExecutorIsKilledEndsCompleteAndEqual() throws Exception {
        Path study = study(KNOWN);
        Path out = folder.resolve("out");
        Process spark = onSpark(study, out, "local-cluster[2,1,1024]");
        String expected = onThreads(study);
        Path journal = out.resolve("journal.csv");
        long begun = System.nanoTime();
        while (spark.isAlive() && lines(journal) < 100 && System.nanoTime() - begun < PATIENCE_S * 1e9) {
            Thread.sleep(5);
        }
        long before = lines(journal);
        List<ProcessHandle> executors = spark.children().toList();
        executors.stream().findFirst().ifPresent(ProcessHandle::destroyForcibly);
        requireDone(spark);
        assertThat(executors).as("executors of two workers").hasSize(2);
        assertThat(before).as("runs before the kill").isBetween(100L, 8_000L);
        assertThat(withoutTimes(out)).isEqualTo(expected).hasLineCount(2048 * 5 + 1);
        assertThat(Files.readString(folder.resolve("log"))).containsIgnoringCase("lost executor");
    }

    private static long lines(Path journal) throws IOException {
        return Files.exists(journal) ? Files.readString(journal).lines().count() : 0;
    }

    /** A full disk of the driver is told as on threads, not as a failure of the cluster. */
    @Test
    void aJournalThatCannotBeWrittenIsToldAsSuch() {
        SweepPlan plan = SweepPlan.of(SweepStudy.parse("study.yaml", KNOWN.replace("2048", "2")));
        OutputException full = new OutputException("journal.csv: writing failed: no space", new IOException());
        System.setProperty("spark.driver.host", "127.0.0.1");
        System.setProperty("spark.driver.bindAddress", "127.0.0.1");
        try (SweepExecutor spark = new SparkService().connect("local[1]")) {
            assertThatThrownBy(() -> spark.run(plan, List.of(0, 1), row -> {
                        throw full;
                    }))
                    .isSameAs(full);
        } finally {
            System.clearProperty("spark.driver.host");
            System.clearProperty("spark.driver.bindAddress");
        }
    }

    /** Before executors have come Spark counts two cores; later ones would wait for tasks of many runs. */
    @Test
    void aStudyOfTenThousandRunsHasATaskForEachRun() {
        assertThat(SparkSweep.tasks(10_000, 2)).isEqualTo(10_000);
        assertThat(SparkSweep.tasks(48, 800)).isEqualTo(48);
        assertThat(SparkSweep.tasks(100_000, 2)).isEqualTo(10_000);
        assertThat(SparkSweep.tasks(100_000, 800)).isEqualTo(32 * 800);
    }

    @Test
    void theMasterOfSparkIsAddedWhereAStudyRuns() {
        List<String> args = List.of("sweep", "study.yaml", "--out", "x");
        assertThat(ClusterMain.withMaster(args, "yarn")).endsWith("--master", "yarn");
        assertThat(ClusterMain.withMaster(args, null)).isEqualTo(args);
        List<String> run = List.of("run", "--out", "sweep");
        assertThat(ClusterMain.withMaster(run, "yarn")).isEqualTo(run);
        assertThat(ClusterMain.withMaster(List.of("sweep", "--merge", "x"), "yarn"))
                .doesNotContain("--master");
        assertThat(ClusterMain.withMaster(List.of("sweep", "--master", "local[1]"), "yarn"))
                .containsExactly("sweep", "--master", "local[1]");
        for (String stated : List.of("--merge=x", "--shard=0/3", "--master=local[2]")) {
            assertThat(ClusterMain.withMaster(List.of("sweep", stated), "yarn")).containsExactly("sweep", stated);
        }
    }
}
