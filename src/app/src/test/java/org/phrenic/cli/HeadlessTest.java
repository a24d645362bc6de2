package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.io.MeshFiles;

/** Commands as a machine without a screen starts them: where that counts, in a Java process of their own. */
class HeadlessTest {
    /** Where libglvnd lists the drivers of EGL, which draws without a display. */
    private static final Path EGL_VENDORS = Path.of("/usr/share/glvnd/egl_vendor.d");

    private static final long PATIENCE_S = 120;
    /** For a process of some seconds the optimizing compiler takes more time than it gains. */
    private static final String SHORT_LIVED = "-XX:TieredStopAtLevel=1";

    private static final List<String> COARSE_RENDER =
            List.of("render", "--resolution", "low", "--set", "mesh_vertices=2000", "--set", "lungs=embedded");

    @TempDir
    Path folder;

    /** A Java process without the variables that add to its options: it names them on its standard error. */
    private static ProcessBuilder java(List<String> options) {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), SHORT_LIVED));
        command.addAll(options);
        ProcessBuilder builder = new ProcessBuilder(command);
        List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "_JAVA_OPTIONS").forEach(builder.environment()::remove);
        return builder;
    }

    /** Starts the program and returns the classes it loaded. */
    private List<String> loadedBy(String... args) throws IOException, InterruptedException {
        Path log = folder.resolve("classes.log");
        List<String> options = new ArrayList<>(List.of(
                "-Xlog:class+load:file=" + log, "-cp", System.getProperty("java.class.path"), Phrenic.class.getName()));
        options.addAll(Arrays.asList(args));
        Process process = java(options)
                .redirectOutput(folder.resolve("stdout").toFile())
                .redirectError(folder.resolve("stderr").toFile())
                .start();
        boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).isTrue();
        assertThat(process.exitValue())
                .as(Files.readString(folder.resolve("stderr")))
                .isZero();
        return Files.readAllLines(log);
    }

    private static void assertNoScreen(List<String> classes) {
        assertThat(classes).anyMatch(line -> line.contains("org.phrenic.cli.Phrenic"));
        assertThat(classes)
                .noneMatch(line -> line.matches(".*\\b(java\\.awt|javax\\.swing|sun\\.awt|com\\.jogamp)\\..*"));
    }

    @Test
    void aRunLoadsNoClassOfTheScreenAndLeavesItsFiles() throws Exception {
        Path out = folder.resolve("out");
        assertNoScreen(loadedBy(
                "run",
                "--resolution",
                "low",
                "--set",
                "mesh_vertices=2000",
                "--duration",
                "0.02",
                "--threads",
                "1",
                "--out",
                out.toString(),
                "--json"));
        String summary = Files.readString(folder.resolve("stdout"));
        // the keys that scripts rely on
        for (String key : List.of(
                "nodes",
                "springs",
                "rigid_links",
                "attachments",
                "steps",
                "dt_s",
                "wall_s",
                "steps_per_s",
                "realtime_factor",
                "max_rigid_link_error",
                "dome_excursion_right_mm",
                "dome_excursion_left_mm",
                "central_tendon_excursion_mm",
                "lung_volume_change_ml",
                "ap_change_mm",
                "transverse_change_mm",
                "sternum_cranial_mm",
                "sternum_ventral_mm",
                "fibre_shortening_percent",
                "liver_si_mm",
                "liver_ap_mm",
                "liver_lr_mm",
                "threads",
                "state_sha256")) {
            assertThat(summary).contains("\"" + key + "\": ");
        }
        String hash = summary.lines()
                .filter(line -> line.contains("state_sha256"))
                .findFirst()
                .orElseThrow();
        assertThat(out.resolve("summary.json")).content().contains(hash);
        assertThat(Files.readAllLines(out.resolve("observables.csv")).get(0)).startsWith("time_s,");
        CommandLineRun again =
                CommandLineRun.of("info", out.resolve("scenario.yaml").toString());
        assertThat(again.out()).containsPattern("resolution +low +file");
    }

    @Test
    void infoLoadsNoClassOfTheScreen() throws Exception {
        assertNoScreen(loadedBy("info", "data/scenarios/quiet.yaml"));
    }

    /** Logs a line as the program does. */
    static final class OneLogLine {
        public static void main(String[] args) {
            Phrenic.printLogWithoutClasses();
            System.getLogger(OneLogLine.class.getName()).log(System.Logger.Level.INFO, "Pictures by {0}", "a card");
        }
    }

    @Test
    void theLogOnStderrNamesNoClass() throws Exception {
        Process process = java(List.of("-cp", System.getProperty("java.class.path"), OneLogLine.class.getName()))
                .redirectError(folder.resolve("stderr").toFile())
                .start();
        assertThat(process.waitFor(PATIENCE_S, TimeUnit.SECONDS)).isTrue();
        assertThat(Files.readAllLines(folder.resolve("stderr"))).containsExactly("Pictures by a card");
    }

    @Test
    void resultsThatCannotBePrintedAreAFailure() throws Exception {
        Path full = Path.of("/dev/full");
        assumeThat(full).exists();
        Process process = java(List.of(
                        "-cp", System.getProperty("java.class.path"), Phrenic.class.getName(), "--version"))
                .redirectOutput(full.toFile())
                .redirectError(folder.resolve("stderr").toFile())
                .start();
        boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).isTrue();
        assertThat(process.exitValue()).isEqualTo(ExitCode.FAILURE);
        assertThat(Files.readAllLines(folder.resolve("stderr")))
                .singleElement()
                .asString()
                .startsWith("phrenic: the results could not be printed: ");
    }

    /** As with phrenic.jar alone, copied away from the folder with the jars that it needs. */
    @Test
    void withoutItsLibrariesTheProgramSaysWhatItNeeds() throws Exception {
        Process process = java(List.of(
                        "-cp",
                        Path.of(Phrenic.class
                                        .getProtectionDomain()
                                        .getCodeSource()
                                        .getLocation()
                                        .toURI())
                                .toString(),
                        Phrenic.class.getName(),
                        "--help"))
                .redirectOutput(folder.resolve("stdout").toFile())
                .redirectError(folder.resolve("stderr").toFile())
                .start();
        boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).isTrue();
        assertThat(Files.readAllLines(folder.resolve("stderr")))
                .singleElement()
                .asString()
                .startsWith("phrenic: found phrenic.jar without its folder lib, expected both side by side");
        assertThat(process.exitValue()).isEqualTo(ExitCode.BAD_INPUT);
    }

    /** Starts {@code render} in a process without a display and returns its exit code. */
    private int render(Map<String, String> environment, String... options) throws IOException, InterruptedException {
        List<String> arguments = new ArrayList<>(COARSE_RENDER);
        arguments.addAll(Arrays.asList(options));
        return execute(environment, arguments);
    }

    /** Starts the program in a process without a display and returns its exit code. */
    private int execute(Map<String, String> environment, List<String> arguments)
            throws IOException, InterruptedException {
        List<String> options = new ArrayList<>(List.of(
                "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path"), Phrenic.class.getName()));
        options.addAll(arguments);
        ProcessBuilder builder = java(options)
                .redirectOutput(folder.resolve("stdout").toFile())
                .redirectError(folder.resolve("stderr").toFile());
        builder.environment().remove("DISPLAY");
        builder.environment().putAll(environment);
        Process process = builder.start();
        boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertThat(ended).isTrue();
        return process.exitValue();
    }

    @Test
    void picturesNeedNoDisplay() throws Exception {
        Path out = folder.resolve("pictures");
        int code = render(Map.of(), "--out", out.toString(), "--view", "left,superior", "--size", "200x150", "--json");
        assumeThat(EGL_VENDORS).as("drivers of EGL").isNotEmptyDirectory();
        assertThat(code).as(Files.readString(folder.resolve("stderr"))).isZero();
        assertThat(Files.readString(folder.resolve("stdout")))
                .contains("superior.png", "\"graphics\": ", Disclaimer.TEXT);
        try (Stream<Path> files = Files.list(out)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder("left.png", "superior.png");
        }
    }

    @Test
    void amongThingsThatAreOnlyKnownOfTheBodyAWrongOneIsToldAndNothingIsWritten() throws Exception {
        Path out = folder.resolve("pictures");
        CommandLineRun hidden = CommandLineRun.of(with(COARSE_RENDER, "--out", out.toString(), "--hide", "livre"));
        assumeThat(hidden.exitCode()).as("something here draws").isNotEqualTo(ExitCode.NO_GRAPHICS);
        assertThat(hidden.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(hidden.err()).contains("did you mean 'liver'?");
        CommandLineRun late = CommandLineRun.of(with(COARSE_RENDER, "--out", out.toString(), "--at", "1e6"));
        assertThat(late.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(late.err()).contains("--at: found 1000000.0 s, expected 0 to 8");
        assertThat(out).doesNotExist();
    }

    private static String[] with(List<String> first, String... more) {
        return Stream.concat(first.stream(), Arrays.stream(more)).toArray(String[]::new);
    }

    /** An environment in which no driver of OpenGL is found. */
    private Map<String, String> drawingNothing() {
        return Map.of(
                "__EGL_VENDOR_LIBRARY_FILENAMES", folder.resolve("none.json").toString());
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void theFiguresOfAComparisonNeedNoPicture() throws Exception {
        Path low = folder.resolve("low.ply");
        Path high = folder.resolve("high.ply");
        Path picture = folder.resolve("map.png");
        MeshFiles.write(low, BoxThorax.box(0, 0, 0, 10));
        MeshFiles.write(high, BoxThorax.box(0, 0, 2, 10));
        List<String> arguments =
                List.of("compare", low.toString(), high.toString(), "--picture", picture.toString(), "--json");
        assertThat(execute(drawingNothing(), arguments)).isEqualTo(ExitCode.NO_GRAPHICS);
        assertThat(Files.readString(folder.resolve("stdout")))
                .contains("\"hausdorff_mm\": 2.0")
                .doesNotContain("\"pictures\"");
        assertThat(picture).doesNotExist();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void whereNothingDrawsOneSentenceSaysSo() throws Exception {
        Path out = folder.resolve("pictures");
        int code = render(drawingNothing(), "--out", out.toString());
        assertThat(code).isEqualTo(ExitCode.NO_GRAPHICS);
        assertThat(Files.readString(folder.resolve("stdout"))).isEmpty();
        assertThat(Files.readAllLines(folder.resolve("stderr")).stream().filter(line -> line.startsWith("phrenic: ")))
                .singleElement()
                .asString()
                .contains("No pictures can be made here");
        assertThat(out).doesNotExist();
    }
}
