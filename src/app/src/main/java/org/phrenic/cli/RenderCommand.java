package org.phrenic.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import org.phrenic.cli.option.MovieOptions;
import org.phrenic.cli.option.PictureOptions;
import org.phrenic.cli.option.RadiographOptions;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.option.ScenarioOptions;
import org.phrenic.cli.option.StyleOptions;
import org.phrenic.cli.option.TimeOptions;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.QuantityKey;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.RadiographRenderer;
import org.phrenic.scene.ScenarioRenderer;
import org.phrenic.scene.Shot;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.FfmpegMovieWriter;
import org.phrenic.scene.export.GifMovieWriter;
import org.phrenic.scene.export.MovieWriter;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.SceneStyle;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic render}: writes pictures and movies of a scenario without a window or a display. */
@Command(
        name = "render",
        description = "Draw pictures or a movie of a scenario; needs no display.",
        footer = {
            "",
            "Examples:",
            "  phrenic render --out pictures --view all",
            "  phrenic render --preset deep --out pictures --at 0,1.5 --only diaphragm --field displacement",
            "  phrenic render --preset deep --out xray --at 0,1.5 --xray 0/0,90/0",
            "  phrenic render --movie breath.mp4 --fps 25 --size 1280x960 --hide skin",
            "",
            "Without --frames or --movie: one picture a view and time, as anterior.png or anterior_1.500s.png. With",
            "--frames: anterior_0001.png and so on. Exit code 4: nothing here can draw.",
            "",
            Disclaimer.TEXT
        })
final class RenderCommand extends ReportingCommand {
    @Mixin
    private ScenarioOptions scenarioOptions;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description =
                    "Folder for the pictures. With --movie it may be left out; else each frame is kept there too.")
    private Path out;

    @Mixin
    private PictureOptions shotOptions;

    @Mixin
    private RadiographOptions radiographOptions;

    @Mixin
    private MovieOptions timeOptions;

    @Mixin
    private StyleOptions styleOptions;

    private final List<OrderedValues> written = new ArrayList<>();
    private MovieWriter movieWriter;

    @Override
    public Integer call() throws NoGraphicsException {
        check();
        Scenario scenario = scenarioOptions.resolved();
        List<PictureSettings> settings = shotOptions.settings(title(scenario));
        int shots = radiographOptions.given() ? radiographOptions.views(1, 1).size() : settings.size();
        if (timeOptions.movie() != null && shots > 1) {
            throw new BadInputException("--movie: found " + shots + " views, expected one");
        }
        ConsoleProgress progress = progress();
        Optional<Path> ffmpeg = timeOptions.isMp4() ? FfmpegMovieWriter.find() : Optional.empty();
        if (timeOptions.isMp4() && ffmpeg.isEmpty()) {
            useGif(progress);
        }
        movieWriter = ffmpeg.<MovieWriter>map(FfmpegMovieWriter::new).orElseGet(GifMovieWriter::new);
        try {
            if (!Annotations.hasFonts()) {
                progress.note("This Java has no fonts: the pictures have no letters.");
            }
            if (radiographOptions.given()) {
                radiographs(scenario, settings.get(0), progress);
            } else {
                drawings(scenario, settings, progress);
            }
        } finally {
            progress.end();
        }
        return ExitCode.SUCCESS;
    }

    /** Before the times of the frames are computed, which depend on how many a second there are. */
    private void useGif(ConsoleProgress progress) {
        Path wanted = timeOptions.movie();
        timeOptions.useGif();
        ReportFolder.requireWritableFile("--movie", timeOptions.movie());
        progress.note("--movie " + wanted + ": found no ffmpeg on the path, writing the animated GIF "
                + timeOptions.movie() + " instead, with at most " + Math.round(GifMovieWriter.MAX_FRAMES_PER_S)
                + " frames a second.");
    }

    private void drawings(Scenario scenario, List<PictureSettings> settings, ConsoleProgress progress)
            throws NoGraphicsException {
        Optional<TriangleMesh> reference = styleOptions.reference();
        try (ScenarioRenderer studio = ScenarioRenderer.open(scenario, progress)) {
            SceneStyle style = styleOptions.style(studio.surfaces());
            reference.ifPresent(studio::setDistanceReference);
            List<NamedShot> shots = settings.stream()
                    .map(s -> new NamedShot(s.view().label(), s.view().label(), s, studio.shot(s, style)))
                    .toList();
            write(shots, studio.durationS());
            progress.end();
            report(Optional.of(studio.graphicsInfo()));
        }
    }

    private void radiographs(Scenario scenario, PictureSettings settings, ConsoleProgress progress) {
        try (RadiographRenderer studio =
                new RadiographRenderer(scenario, progress, radiographOptions.energyKev(), scenario.threads())) {
            List<NamedShot> shots = new ArrayList<>();
            for (RadiographRenderer.View view : radiographOptions.views(settings.width(), settings.height())) {
                Optional<String> title = Optional.of(settings)
                        .filter(PictureSettings::annotated)
                        .map(s -> s.title() + ", " + view.label());
                String file = RadiographOptions.fileName(view);
                shots.add(new NamedShot(file, view.label(), settings, studio.shot(view, title)));
            }
            write(shots, studio.durationS());
            progress.end();
            report(Optional.empty());
        }
    }

    private void check() {
        timeOptions.validate();
        timeOptions.requireApart();
        styleOptions.validate();
        radiographOptions.validate();
        if (radiographOptions.given()) {
            requireRead(
                    name -> !StyleOptions.NAMES.contains(name) && !PictureOptions.OF_DRAWINGS.contains(name),
                    "with --xray, whose pictures do not depend on it");
        }
        shotOptions.settings("");
        if (out == null && timeOptions.movie() == null) {
            throw new BadInputException("--out: found none, expected a folder for the pictures");
        }
        if (out != null) {
            ReportFolder.requireWritable(out);
        }
        ReportFolder.requireWritableFile("--movie", timeOptions.movie());
    }

    private static String title(Scenario scenario) {
        String label = RunSettings.bodyLabel(scenario.anatomy());
        String body = scenario.isVirtual() ? label.replace('/', ' ').replace('-', ' ') : label;
        String name = scenario.name().replace('-', ' ');
        return name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1) + ", " + body;
    }

    /**
     * A shot with its names.
     *
     * @param file beginning of the names of its files
     * @param view name in the report
     * @param settings size of its pictures
     */
    private record NamedShot(String file, String view, PictureSettings settings, Shot shot) {}

    private void write(List<NamedShot> shots, double durationS) {
        double[] times = timeOptions.times(durationS);
        if (timeOptions.movie() != null) {
            movie(shots.get(0), times, timeOptions.framesPerS(times.length, durationS));
            return;
        }
        for (int i = 0; i < times.length; i++) {
            for (NamedShot shot : shots) {
                Path file = picture(shot, i, times);
                shot.shot().writePicture(file, times[i]);
                list(file, shot, times[i], 1);
            }
        }
    }

    private Path picture(NamedShot shot, int index, double[] times) {
        String suffix = timeOptions.isSequence()
                ? Numbers.format("_%04d", index + 1)
                : times.length == 1 ? "" : "_" + TimeOptions.label(times[index]);
        return out.resolve(shot.file() + suffix + ".png");
    }

    private void movie(NamedShot shot, double[] times, double framesPerS) {
        Optional<IntFunction<Path>> single = Optional.ofNullable(out).map(folder -> i -> picture(shot, i, times));
        Path file = timeOptions.movie();
        shot.shot().writeMovie(file, movieWriter, framesPerS, times, single);
        list(file, shot, times[0], times.length);
    }

    private void list(Path file, NamedShot shot, double timeS, int frames) {
        written.add(new OrderedValues()
                .with("file", file.toString())
                .with("view", shot.view())
                .with("time_s", timeS)
                .with("width", shot.settings().width())
                .with("height", shot.settings().height())
                .with("frames", frames));
    }

    private void report(Optional<GraphicsInfo> graphics) {
        OrderedValues report = new OrderedValues().with("pictures", written);
        graphics.ifPresent(info -> report.with("graphics", info.renderer()).with("opengl", info.version()));
        report.with("notice", Disclaimer.TEXT);
        TextTable table = new TextTable(Column.list("file | view | # time_s | # size | # frames"));
        for (OrderedValues row : written) {
            table.row(
                    row.get("file").toString(),
                    row.get("view").toString(),
                    QuantityKey.format(row.get("time_s")),
                    row.get("width") + "x" + row.get("height"),
                    row.get("frames").toString());
        }
        print(report, () -> withDisclaimer(table.text()));
    }
}
