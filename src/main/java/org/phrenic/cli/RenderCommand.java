package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.format.BadInputException;
import org.phrenic.format.Json;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.scene.FfmpegMovie;
import org.phrenic.scene.GifMovie;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.scene.SceneStyle;
import org.phrenic.scene.Shot;
import org.phrenic.scene.Studio;
import org.phrenic.simulation.Scenario;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code phrenic render}: pictures and movies of a scenario without a window and without a display. */
@Command(
        name = "render",
        description = "Draw pictures or a movie of a scenario; needs no display.",
        footer = {
            "",
            "Examples:",
            "  phrenic render --out pictures --view all",
            "  phrenic render --preset deep --out pictures --at 0,1.5 --only diaphragm --field displacement",
            "  phrenic render --movie breath.mp4 --fps 25 --size 1280x960 --hide skin",
            "",
            "Without --frames or --movie: one picture a view and time, as anterior.png or anterior_1.50s.png. With",
            "--frames: anterior_0001.png and so on. Exit code 4: nothing here can draw.",
            "",
            Notice.TEXT
        })
final class RenderCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Mixin
    private ScenarioOptions scenarioOptions;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description =
                    "Folder for the pictures. With --movie it may be left out; else each frame is kept there too.")
    private Path out;

    @Mixin
    private ShotOptions shotOptions;

    @Mixin
    private TimeOptions timeOptions;

    @Mixin
    private StyleOptions styleOptions;

    @Option(names = "--json", description = "List what was made as JSON instead of a table.")
    private boolean json;

    private final List<Map<String, Object>> made = new ArrayList<>();

    @Override
    public Integer call() throws NoGraphicsException {
        check();
        Scenario scenario = scenarioOptions.resolved();
        Optional<TriangleMesh> reference = styleOptions.reference();
        List<Shot> shots = shotOptions.shots(title(scenario));
        if (timeOptions.movie() != null && shots.size() > 1) {
            throw new BadInputException("--movie: found " + shots.size() + " views, expected one");
        }
        PrintWriter err = spec.commandLine().getErr();
        ProgressPrinter progress = new ProgressPrinter(err, ProgressPrinter.isTerminal());
        try (Studio studio = Studio.open(scenario, progress)) {
            if (!studio.canWriteLetters()) {
                progress.note("This Java has no fonts: the pictures have no letters.");
            }
            SceneStyle style = styleOptions.on(studio.surfaces());
            reference.ifPresent(studio::measureFrom);
            double[] times = timeOptions.times(studio.totalS());
            if (timeOptions.movie() == null) {
                pictures(studio, shots, style, times);
            } else {
                movie(studio, shots.get(0), style, times, progress);
            }
            progress.end();
            report(studio);
        } finally {
            progress.end();
        }
        return ExitCode.DONE;
    }

    private void check() {
        timeOptions.check();
        styleOptions.check();
        shotOptions.shots("");
        if (out == null && timeOptions.movie() == null) {
            throw new BadInputException("--out: found none, expected a folder for the pictures");
        }
        if (out != null) {
            OutputFolder.require(out);
        }
        if (timeOptions.movie() != null) {
            Path folder = timeOptions.movie().toAbsolutePath().getParent();
            OutputFolder.require(folder);
        }
    }

    private static String title(Scenario scenario) {
        String body = scenario.isVirtual()
                ? scenario.anatomy().replace('/', ' ').replace('-', ' ')
                : String.valueOf(Path.of(scenario.anatomy()).getFileName());
        String name = scenario.name().replace('-', ' ');
        return name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1) + ", " + body;
    }

    private void pictures(Studio studio, List<Shot> shots, SceneStyle style, double[] times) {
        for (int i = 0; i < times.length; i++) {
            for (Shot shot : shots) {
                Path file = picture(shot, i, times);
                studio.picture(file, times[i], shot, style);
                list(file, shot, times[i], 1);
            }
        }
    }

    private Path picture(Shot shot, int index, double[] times) {
        return out.resolve(shot.view().label() + suffix(index, times) + ".png");
    }

    private String suffix(int index, double[] times) {
        if (timeOptions.isSequence()) {
            return String.format(Locale.ROOT, "_%04d", index + 1);
        }
        return times.length == 1 ? "" : String.format(Locale.ROOT, "_%.3fs", times[index]);
    }

    private void movie(Studio studio, Shot shot, SceneStyle style, double[] times, ProgressPrinter progress) {
        double framesPerS = timeOptions.framesPerS(times.length, studio.totalS());
        Path file = timeOptions.movie();
        Optional<Path> ffmpeg = timeOptions.isMp4() ? FfmpegMovie.find() : Optional.empty();
        if (timeOptions.isMp4() && ffmpeg.isEmpty()) {
            file = file.resolveSibling(file.getFileName().toString().replaceFirst("(?i)mp4$", "gif"));
            progress.note("--movie " + timeOptions.movie() + ": found no ffmpeg on the path, writing the animated GIF "
                    + file + " instead.");
            framesPerS = Math.min(framesPerS, GifMovie.FASTEST);
        }
        studio.movie(
                file,
                ffmpeg.<org.phrenic.scene.Movie>map(FfmpegMovie::new).orElseGet(GifMovie::new),
                framesPerS,
                times,
                shot,
                style,
                Optional.ofNullable(out).map(folder -> i -> picture(shot, i, times)));
        list(file, shot, times[0], times.length);
    }

    private void list(Path file, Shot shot, double timeS, int frames) {
        Map<String, Object> row = new LinkedHashMap<>();
        row.put("file", file.toString());
        row.put("view", shot.view().label());
        row.put("time_s", timeS);
        row.put("width", shot.width());
        row.put("height", shot.height());
        row.put("frames", frames);
        made.add(row);
    }

    private void report(Studio studio) {
        PrintWriter stdout = spec.commandLine().getOut();
        if (json) {
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("pictures", made);
            report.put("graphics", studio.graphics().renderer());
            report.put("opengl", studio.graphics().version());
            report.put("notice", Notice.TEXT);
            stdout.print(Json.format(report));
        } else {
            Table table = new Table(false, false, true, true, true).row("file", "view", "time_s", "size", "frames");
            for (Map<String, Object> row : made) {
                table.row(
                        row.get("file").toString(),
                        row.get("view").toString(),
                        Quantity.shown(row.get("time_s")),
                        row.get("width") + "x" + row.get("height"),
                        row.get("frames").toString());
            }
            stdout.print(table.text() + "\n" + Notice.TEXT + "\n");
        }
        stdout.flush();
    }
}
