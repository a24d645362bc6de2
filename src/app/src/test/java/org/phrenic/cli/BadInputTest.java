package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.mesh.io.MeshFiles;

/**
 * Whatever is wrong with what a user gives: exit code 2, one line that names it, nothing on stdout, nothing written.
 */
class BadInputTest {
    private static final String TETRAHEDRON =
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

    @TempDir
    Path folder;

    /** Prepares files and gives the arguments. */
    private interface Case extends Function<Path, List<String>> {}

    private static Arguments bad(String what, String expectedInSentence, Case arguments) {
        return Arguments.of(what, expectedInSentence, arguments);
    }

    private static String file(Path folder, String name, String text) {
        return bytes(folder, name, text.getBytes(StandardCharsets.UTF_8));
    }

    private static String bytes(Path folder, String name, byte[] bytes) {
        try {
            return Files.write(folder.resolve(name), bytes).toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Case info(String name, String text) {
        return folder -> List.of("info", file(folder, name, text));
    }

    private static Case run(String yaml) {
        return folder -> List.of("run", file(folder, "s.yaml", yaml), "--out", out(folder));
    }

    private static Case options(String... options) {
        return folder -> Stream.concat(Stream.of("run", "--out", out(folder)), Arrays.stream(options))
                .toList();
    }

    private static String out(Path folder) {
        return folder.resolve("result").toString();
    }

    /** A mesh as the program writes it, without its last bytes. */
    private static Case cut(String name, int missing) {
        return folder -> {
            Path whole = folder.resolve(name);
            MeshFiles.write(whole, BoxThorax.box(0, 0, 0, 1));
            try {
                byte[] content = Files.readAllBytes(whole);
                return List.of("info", bytes(folder, name, Arrays.copyOf(content, content.length - missing)));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        };
    }

    private static Case bench(String fixed, String loaded, String links, String... more) {
        return folder -> Stream.concat(
                        Stream.of(
                                "bench",
                                "--mesh",
                                file(folder, "m.obj", TETRAHEDRON),
                                "--fixed",
                                file(folder, "fixed.txt", fixed),
                                "--loaded",
                                file(folder, "loaded.txt", loaded),
                                "--links",
                                file(folder, "links.txt", links)),
                        Arrays.stream(more))
                .toList();
    }

    private static Case thorax(Function<Path, Path> made) {
        return folder -> {
            try {
                Path body = Files.createDirectory(folder.resolve("body"));
                made.apply(body);
                return List.of("run", "--anatomy", body.toString(), "--out", out(folder));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        };
    }

    static Stream<Arguments> meshes() {
        return Stream.of(
                bad("missing mesh", "none.ply", f -> List.of("info", f + "/none.ply")),
                bad("file of unknown kind", "x.docx", info("x.docx", "hello")),
                bad("packed folder", "unpack it first", info("masks.zip", "hello")),
                bad("folder as a mesh", "expected", f -> {
                    f.resolve("d.ply").toFile().mkdir();
                    return List.of("bench", "--mesh", f + "/d.ply", "--fixed", "a", "--loaded", "b");
                }),
                bad("truncated PLY", "m.ply", cut("m.ply", 5)),
                bad("truncated STL", "m.stl", cut("m.stl", 7)),
                bad("truncated VTP", "m.vtp", cut("m.vtp", 40)),
                bad("truncated OBJ", "m.obj", info("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1")),
                bad("empty mesh file", "m.ply", info("m.ply", "")),
                bad("NaN coordinate", "nan", info("m.obj", TETRAHEDRON.replace("v 1 0 0", "v nan 0 0"))),
                bad("infinite coordinate", "inf", info("m.obj", TETRAHEDRON.replace("v 1 0 0", "v inf 0 0"))),
                bad("coordinate that overflows", "1e999", info("m.obj", TETRAHEDRON.replace("v 1 0 0", "v 1e999 0 0"))),
                bad("no triangle", "triangle", info("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")),
                bad(
                        "index out of range",
                        "vertex index 8 (counted from 0)",
                        info("m.obj", TETRAHEDRON.replace("f 2 3 4", "f 2 3 9"))));
    }

    static Stream<Arguments> scenarios() {
        return Stream.of(
                bad("missing scenario", "none.yaml", f -> List.of("run", f + "/none.yaml", "--out", out(f))),
                bad(
                        "empty folder as scenario",
                        "no mesh has the name of a structure",
                        f -> List.of("run", f.toString(), "--out", out(f))),
                bad("empty scenario", "no keys", run("# nothing\n")),
                bad("unknown key", "did you mean 'preset'?", run("prest: quiet\n")),
                bad("key twice", "line 2", run("preset: quiet\npreset: deep\n")),
                bad("list for a number", "found a list", run("depth: [1, 2]\n")),
                bad("text for a number", "expected a number", run("time_step_s: fast\n")),
                bad("text for true or false", "expected true or false", run("muscle: maybe\n")),
                bad("fraction for a whole number", "expected a whole number", run("threads: 1.5\n")),
                bad("no mapping", "expected", run("- quiet\n")),
                bad("broken YAML", "line", run("preset: [quiet\n")),
                bad("not UTF-8", "UTF-8", f -> List.of("run", bytes(f, "s.yaml", new byte[] {'a', (byte) 0xff, ':'}))),
                bad("time step 0", "expected at least 1.0E-5", run("time_step_s: 0\n")),
                bad("negative time step", "expected at least 1.0E-5", run("time_step_s: -0.001\n")),
                bad("time step NaN", "expected a number", run("time_step_s: .nan\n")),
                bad("duration 0", "expected more than 0", run("duration_s: 0\n")),
                bad("duration shorter than a step", "at least one step", run("duration_s: 0.0001\n")),
                bad(
                        "name with a control character",
                        "found a name with a control character",
                        run("name: \"a\\u0007b\"\n")),
                bad("empty name", "found an empty name", run("name: ''\n")),
                bad(
                        "scenario in the folder of the result",
                        "a file that the command reads",
                        f -> List.of("run", file(f, "scenario.yaml", "preset: deep\n"), "--out", f.toString())),
                bad("body in the folder of the result's meshes", "meshes: found a folder that the command reads", f -> {
                    Path body = f.resolve("meshes");
                    BoxThorax.write(body, 140, 1);
                    return List.of("run", body.toString(), "--out", f.toString());
                }),
                bad("body in the folder of an unfinished run", "meshes.part: found a folder that the command", f -> {
                    Path body = f.resolve("meshes.part");
                    BoxThorax.write(body, 140, 1);
                    return List.of("run", "--anatomy", body.toString(), "--out", f.toString());
                }),
                bad("negative mass", "found -1", run("material: paper\nnode_mass_kg: -1\n")),
                bad("parameter of the other material", "paper", run("node_mass_kg: 0.1\n")),
                bad("unknown preset", "expected one of quiet", run("preset: dep\n")),
                bad("unknown integrator", "did you mean 'verlet'?", run("integrator: verlot\n")),
                bad("unknown resolution", "low, medium, high", run("resolution: huge\n")),
                bad("unknown body", "virtual/adult-male", run("anatomy: virtual/child\n")),
                bad("missing trace", "no file", run("trace: none.csv\n")),
                bad("trace without columns", "c.csv", f -> {
                    file(f, "c.csv", "a,b\n1,2\n");
                    return run("trace: c.csv\n").apply(f);
                }),
                bad("trace with a word", "line 3", f -> {
                    file(f, "c.csv", "time_s,amplitude\n0,0\n1,high\n");
                    return run("trace: c.csv\n").apply(f);
                }));
    }

    static Stream<Arguments> options() {
        return Stream.of(
                bad("unknown command", "run, render, info, bench", f -> List.of("nope")),
                bad("mistyped command", "did you mean 'bench'?", f -> List.of("bensh")),
                bad("unknown option", "did you mean '--threads'?", options("--theads", "2")),
                bad("option without value", "--threads", options("--threads")),
                bad("threads 0", "--threads 0", options("--threads", "0")),
                bad("threads a word", "expected a whole number", options("--threads", "all")),
                bad("threads beyond all bounds", "1 to 256", options("--threads", "99999999999")),
                bad("--set without =", "expected key=value", options("--set", "depth")),
                bad("--set without key", "expected key=value", options("--set", "=1")),
                bad("--set without value", "expected a number", options("--set", "depth=")),
                bad("--set of an unknown key", "did you mean 'depth'?", options("--set", "depht=1")),
                bad("--set out of range", "expected 0 to 2", options("--set", "depth=2.5")),
                bad("--set NaN", "expected a number", options("--set", "depth=NaN")),
                bad("--set with YAML in it", "expected a number", options("--set", "depth={a: 1}")),
                bad("--duration negative", "--duration -1", options("--duration", "-1")),
                bad(
                        "change after the end",
                        "found step 9 after the end of the run",
                        options("--steps", "8", "--change", "9:depth=1")),
                bad(
                        "change after the duration",
                        "at most step 800",
                        options("--duration", "1", "--change", "801:depth=1")),
                bad(
                        "change after a longer step",
                        "at most step 450",
                        options("--duration", "1", "--change", "400:time_step_s=0.01", "--change", "451:depth=1")),
                bad(
                        "setting of the other material",
                        "which does not use it",
                        options("--material", "paper", "--set", "mass_scaling_s=0.001")),
                bad(
                        "material beside a setting of the other",
                        "mass_scaling_s",
                        f -> List.of("run", file(f, "s.yaml", "mass_scaling_s: 0.001\n"), "--material", "published")),
                bad(
                        "error and step",
                        "--time-step: found it with --max-error",
                        options("--max-error", "1", "--time-step", "0.001")),
                bad(
                        "error and sweeps",
                        "a key that --max-error sets",
                        options("--max-error", "1", "--set", "projection_sweeps=2")),
                bad(
                        "error and a later step",
                        "--change 100:time_step_s=0.01: found a key that --max-error sets",
                        options("--max-error", "1", "--change", "100:time_step_s=0.01")),
                bad(
                        "error and a later integrator of the file",
                        "a key that --max-error sets",
                        f -> List.of("run", file(f, "s.yaml", "changes: ['9:integrator=rk2']\n"), "--max-error", "1")),
                bad(
                        "published model of another material",
                        "--material physical: found it with --preset paper",
                        options("--preset", "paper", "--material", "physical")),
                bad("changes as --set", "--change of a run", options("--set", "changes=5:depth=1")),
                bad("--meshes without every", "every=S", options("--meshes", "0.1")),
                bad("--meshes without --out", "--out", f -> List.of("run", "--meshes", "every=0.1")),
                bad(
                        "--out below a file",
                        "expected a folder",
                        f -> List.of("run", "--out", file(f, "taken", "x") + "/deeper")),
                bad("--out is a file", "expected a folder", f -> List.of("run", "--out", file(f, "taken", "x"))));
    }

    static Stream<Arguments> bodies() {
        return Stream.of(
                bad("no diaphragm", "no diaphragm", thorax(body -> {
                    BoxThorax.save(body, "rib_01_L", 100, 0, 0, 1);
                    return body;
                })),
                bad("empty folder", "no mesh has the name of a structure", thorax(body -> body)),
                bad("mirrored body", "mirrored", thorax(body -> BoxThorax.write(body, -140, 1))),
                bad("wrong unit", "units", thorax(body -> BoxThorax.write(body, 140, 20))),
                bad("two files for one structure", "one file a structure", thorax(body -> {
                    BoxThorax.write(body, 140, 1);
                    MeshFiles.write(body.resolve("diaphragm.stl"), BoxThorax.box(0, 0, 100, 10));
                    return body;
                })),
                bad("broken structure", "diaphragm.ply", thorax(body -> {
                    BoxThorax.write(body, 140, 1);
                    file(body, "diaphragm.ply", "ply\nformat ascii 1.0\n");
                    return body;
                })),
                bad("unknown key in thorax.yaml", "unknown key", thorax(body -> {
                    BoxThorax.write(body, 140, 1);
                    file(body, "thorax.yaml", "axis: LPS\n");
                    return body;
                })),
                bad("left-handed axes", "left-handed", thorax(body -> {
                    BoxThorax.write(body, 140, 1);
                    file(body, "thorax.yaml", "axes: RPS\nunits: mm\n");
                    return body;
                })),
                bad("unknown unit", "mm, cm or m", thorax(body -> {
                    BoxThorax.write(body, 140, 1);
                    file(body, "thorax.yaml", "axes: LPS\nunits: inch\n");
                    return body;
                })));
    }

    static Stream<Arguments> benches() {
        return Stream.of(
                bad("no mesh", "--mesh", f -> List.of("bench")),
                bad(
                        "no loaded vertices",
                        "found no --loaded FILE (",
                        f -> List.of("bench", "--mesh", "a", "--fixed", "b")),
                bad("no such door", "--door", f -> List.of("bench", "window", "--door", "front")),
                bad("no width", "--width: found 0, expected 200 to", f -> List.of("bench", "window", "--width", "0")),
                bad("no height", "--height: found -5", f -> List.of("bench", "window", "--height", "-5")),
                bad(
                        "option before a sub-command",
                        "--threads: found it before 'window', which does not read it",
                        f -> List.of("bench", "--threads", "2", "window", "--door", "front")),
                bad(
                        "JSON before a sub-command",
                        "--json: found it before 'window'",
                        f -> List.of("bench", "--json", "window", "--door", "front")),
                bad("no whole interval", "--seconds", f -> List.of("bench", "window", "--seconds", "1")),
                bad(
                        "missing index file",
                        "none.txt",
                        f -> List.of(
                                "bench",
                                "--mesh",
                                file(f, "m.obj", TETRAHEDRON),
                                "--fixed",
                                f + "/none.txt",
                                "--loaded",
                                "x")),
                bad("vertex out of range", "'4'", bench("4\n", "1\n", "")),
                bad("negative vertex", "'-1'", bench("0\n", "-1\n", "")),
                bad("vertex a word", "'zero'", bench("zero\n", "1\n", "")),
                bad("vertex twice", "again", bench("0\n0\n", "1\n", "")),
                bad("two indices where one is expected", "line 1", bench("0 1\n", "1\n", "")),
                bad("one index where two are expected", "line 1", bench("0\n", "1\n", "2\n")),
                bad("nothing loaded", "expected at least one", bench("0\n", "", "")),
                bad("steps 0", "--steps: found 0", bench("0\n", "1\n", "", "--steps", "0")),
                bad("threads 0", "--threads: found 0", bench("0\n", "1\n", "", "--threads", "0")),
                bad("steps a word", "--steps", bench("0\n", "1\n", "", "--steps", "many")),
                bad(
                        "unknown integrator",
                        "--integrator: found 'euler'",
                        bench("0\n", "1\n", "", "--integrator", "euler")));
    }

    private static Case render(String... options) {
        return folder -> Stream.concat(Stream.of("render", "--out", out(folder)), Arrays.stream(options))
                .toList();
    }

    static Stream<Arguments> renders() {
        return Stream.of(
                bad("no folder for pictures", "--out", f -> List.of("render")),
                bad(
                        "pictures below a file",
                        "expected a folder",
                        f -> List.of("render", "--out", file(f, "t", "x") + "/d")),
                bad(
                        "movie below a file",
                        "phrenic: --movie ",
                        f -> List.of("render", "--movie", file(f, "t", "x") + "/m.gif")),
                bad("unknown view", "did you mean 'anterior'?", render("--view", "anteriour")),
                bad("view that is none of six", "expected one of anterior", render("--view", "oblique-ish")),
                bad("empty view", "--view", render("--view", "left,,right")),
                bad("size without x", "expected WxH", render("--size", "1000")),
                bad("size of words", "expected a number", render("--size", "widexhigh")),
                bad("size with a fraction", "whole number", render("--size", "100.5x100")),
                bad("size too small", "expected 16 to 8192", render("--size", "15x100")),
                bad("size too large", "expected 16 to 8192", render("--size", "100x8193")),
                bad("negative size", "expected 16 to 8192", render("--size", "-100x100")),
                bad("three sizes", "expected WxH", render("--size", "1x2x3")),
                bad("time a word", "expected a number", render("--at", "noon")),
                bad("time NaN", "expected a number", render("--at", "0,NaN")),
                bad("time and frames", "single times or a sequence", render("--at", "1", "--frames", "3")),
                bad("time and movie", "single times or a sequence", render("--at", "1", "--movie", "m.gif")),
                bad("times of one file", "which give one file 1.000s", render("--at", "1,1.0001")),
                bad(
                        "radiograph with a clip",
                        "--clip: found it with --xray",
                        render("--xray", "0/0", "--clip", "A:20")),
                bad("radiograph with a zoom", "--zoom: found it with --xray", render("--xray", "0/0", "--zoom", "2")),
                bad("radiograph with a view", "--view: found it", render("--xray", "0/0", "--view", "left")),
                bad("no frames", "expected 1 to", render("--frames", "0")),
                bad("half a frame", "whole number", render("--frames", "2.5")),
                bad("rate without a movie", "found no --movie", render("--fps", "25")),
                bad("rate of single pictures", "found no --movie", render("--fps", "25", "--frames", "3")),
                bad("rate beyond GIF", "expected 0.1 to 50", render("--movie", "m.gif", "--fps", "60")),
                bad("rate 0", "--fps: found 0", render("--movie", "m.gif", "--fps", "0")),
                bad("movie of an unknown kind", "expected .mp4 or .gif", render("--movie", "m.avi")),
                bad("movie of two views", "found 2 views", render("--movie", "m.gif", "--view", "left,right")),
                bad("unknown field", "did you mean 'displacement'?", render("--field", "displacment")),
                bad("distance from nothing", "--reference", render("--field", "distance")),
                bad("reference without distance", "--field distance", render("--reference", "a.ply")),
                bad("range without a field", "--field", render("--range", "0:10")),
                bad("range without colon", "MIN:MAX", render("--field", "strain", "--range", "10")),
                bad("range the wrong way", "smaller number first", render("--field", "strain", "--range", "10:-10")),
                bad("range of words", "expected a number", render("--field", "strain", "--range", "low:high")),
                bad("unknown background", "light, dark", render("--background", "sunset")),
                bad("unknown side of a clip", "L R A P S I", render("--clip", "X:10")),
                bad("clip without a distance", "expected a number", render("--clip", "A:")),
                bad("clip beyond the world", "-100000 to 100000 mm", render("--clip", "A:1e9")),
                bad("unknown overlay", "did you mean 'springs'?", render("--overlay", "spring")),
                bad("zoom 0", "--zoom", render("--zoom", "0")),
                bad("zoom infinite", "expected a number", render("--zoom", "Infinity")),
                bad("option of another command", "unknown option", render("--meshes", "every=1")),
                bad("scenario that is missing", "none.yaml", f -> List.of("render", f + "/none.yaml", "--out", out(f))),
                bad("parameter out of range", "expected 0 to 2", render("--set", "depth=3")));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource({"meshes", "scenarios", "options", "bodies", "benches", "renders"})
    void isToldInOneSentenceAndNothingIsWritten(String what, String expected, Case arguments) throws IOException {
        String[] args = arguments.apply(folder).toArray(String[]::new);
        List<Path> before = everything();
        CommandLineRun run = CommandLineRun.of(args);
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.out()).isEmpty();
        assertThat(run.err().lines()).as(run.err()).hasSize(1);
        assertThat(run.err()).startsWith("phrenic: ").contains(expected).doesNotContain("Exception");
        assertThat(everything()).isEqualTo(before);
    }

    private List<Path> everything() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.sorted().toList();
        }
    }
}
