package org.phrenic.cli.bench;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.option.ScenarioOptions;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.bare.BareScene;
import org.phrenic.study.bare.BareSettings;
import org.phrenic.study.bare.BareWorkload;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.window.WindowBenchmark;
import org.phrenic.ui.window.WindowStart;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic bench window}: opens the window and measures simulated time, frames and processor time in it. */
@Command(
        name = "window",
        description = "Open the window and measure its speed: simulated over real time in every 5 s, frames per second,"
                + " processor share, first picture; then the bare workload on the same sheet.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench window --seconds 60 --door researcher     about 80 s",
            "  phrenic bench window --seconds 60 --door rehearsal",
            "",
            "With --out, DIR gets window.md and window.json.",
            "A display is needed; without one: exit code 4 and one sentence. Other programs at work lower every figure."
        })
final class BenchWindowCommand extends ReportingCommand {
    private static final double MAX_SECONDS = 3600;
    private static final int BARE_STEPS = 400;
    /** Least width and height of a window in which something can be seen, pixels. */
    private static final int LEAST_PIXELS = 200;
    /** Greatest width and height of a window, pixels; a screen of 8K is 7680 wide. */
    private static final int MOST_PIXELS = 16_384;

    @Mixin
    private ScenarioOptions scenario;

    @Option(
            names = "--seconds",
            paramLabel = "S",
            description = "Wall time to measure, in whole intervals of 5 s (default ${DEFAULT-VALUE}).")
    private double seconds = 60;

    @Option(names = "--door", paramLabel = "NAME", description = "researcher or rehearsal (default ${DEFAULT-VALUE}).")
    private String door = "researcher";

    @Option(names = "--turn", description = "Turn the camera about the body all the time.")
    private boolean turn;

    @Option(
            names = "--width",
            paramLabel = "PIXELS",
            description = "Wanted width of the window (default ${DEFAULT-VALUE}).")
    private int width = 1280;

    @Option(
            names = "--height",
            paramLabel = "PIXELS",
            description = "Wanted height of the window (default ${DEFAULT-VALUE}).")
    private int height = 800;

    @Mixin
    private ProvenanceOption made;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() throws NoGraphicsException {
        out.check();
        Workspace workspace = workspace();
        if (!(seconds >= WindowBenchmark.INTERVAL_S && seconds <= MAX_SECONDS)) {
            throw new BadInputException(
                    "--seconds: found " + seconds + ", expected " + WindowBenchmark.INTERVAL_S + " to " + MAX_SECONDS);
        }
        requirePixels("--width", width);
        requirePixels("--height", height);
        Optional<String> obstacle = WindowStart.obstacle();
        if (obstacle.isPresent()) {
            err().println(obstacle.get() + ".");
            return ExitCode.NO_GRAPHICS;
        }
        WindowBenchmark.Result result = WindowBenchmark.run(
                scenario.resolved(),
                new WindowBenchmark.Settings(workspace, seconds, width, height, turn),
                interval -> err().println(text(interval)));
        OrderedValues values = values(result);
        TextTable table = new TextTable(false, false);
        values.forEach((key, value) -> table.row(key, String.valueOf(value)));
        out.write("window.md", MarkdownPage.format(page(result.frame(), values)));
        out.write("window.json", values);
        print(values, table::text);
        return ExitCode.SUCCESS;
    }

    private Workspace workspace() {
        return switch (door) {
            case "researcher" -> Workspace.RESEARCHER;
            case "rehearsal" -> Workspace.CLINICIAN;
            default -> throw new BadInputException("--door: found '" + door + "', expected researcher or rehearsal");
        };
    }

    private static void requirePixels(String option, int pixels) {
        if (pixels < LEAST_PIXELS || pixels > MOST_PIXELS) {
            throw new BadInputException(
                    option + ": found " + pixels + ", expected " + LEAST_PIXELS + " to " + MOST_PIXELS);
        }
    }

    private ReportDocument page(String frame, OrderedValues values) {
        ReportDocument page = new ReportDocument(
                "Pace of the window, " + door,
                "A window of " + frame + " pixels on "
                        + scenario.resolved().anatomy() + ", "
                        + ReportNumbers.label(scenario.resolved().resolution()) + " resolution, measured for "
                        + WindowBenchmark.measuredS(seconds) + " s after a warm-up.");
        page.points(made.lines().toArray(String[]::new));
        page.paragraph("Real time: simulated over wall time; least over any " + WindowBenchmark.INTERVAL_S
                + " s, and mean. Processors: processor time over wall time, of the process and of its threads. Bare"
                + " steps: the bare workload on the sheet of this scene, on one thread and on two.");
        List<List<String>> rows = new ArrayList<>();
        values.forEach((key, value) -> rows.add(List.of(key.replace('_', ' '), String.valueOf(value))));
        page.table("", Column.list("quantity | value"), rows);
        return page;
    }

    private static String text(WindowBenchmark.Interval interval) {
        return Numbers.format(
                "%.3f x real time, %.1f frames/s, %.2f processors, drawn at %.2f",
                interval.realtimeFactor(), interval.framesPerS(), interval.processors(), interval.resolution());
    }

    private OrderedValues values(WindowBenchmark.Result result) {
        double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        OrderedValues values = new OrderedValues()
                .with("door", door)
                .with("camera", turn ? "turning" : "at rest")
                .with("first_picture_s", rounded(result.firstPictureS()))
                .with("ready_s", rounded(result.readyS()))
                .with("realtime_least", rounded(result.leastRealtimeFactor()))
                .with("realtime_mean", rounded(result.meanRealtimeFactor()))
                .with("frames_per_s_least", rounded(result.leastFramesPerS()))
                .with("frames_per_s_mean", rounded(result.meanFramesPerS()))
                .with("processors_used", rounded(result.meanProcessors()))
                .with("processors", Runtime.getRuntime().availableProcessors())
                .with("load_average", rounded(load))
                .with("window", result.frame())
                .with("view", result.view());
        List<Double> factors = new ArrayList<>();
        result.intervals().forEach(interval -> factors.add(rounded(interval.realtimeFactor())));
        values.with("realtime", factors);
        result.threadShares().forEach((name, share) -> values.with("thread " + name, rounded(share)));
        for (int threads = 1; threads <= 2; threads++) {
            BareSettings bare = BareSettings.DEFAULT.withThreads(threads).withSteps(BARE_STEPS);
            double rate = BareWorkload.run(bareScene(result.sheet()), bare).stepsPerSecond();
            values.with("bare_steps_per_s_" + threads, Math.round(rate));
        }
        return values;
    }

    /** The sheet of the scene, held at its border and loaded elsewhere. */
    private static BareScene bareScene(TriangleMesh sheet) {
        EdgeTable table = new EdgeTable(sheet);
        boolean[] border = new boolean[sheet.vertexCount()];
        for (int e = 0; e < table.edgeCount(); e++) {
            if (table.faceCount(e) == 1) {
                border[table.edges()[2 * e]] = true;
                border[table.edges()[2 * e + 1]] = true;
            }
        }
        int[] fixed = IntStream.range(0, border.length).filter(v -> border[v]).toArray();
        int[] loaded = IntStream.range(0, border.length).filter(v -> !border[v]).toArray();
        return new BareScene(sheet, fixed, loaded, new int[0]);
    }

    private static double rounded(double value) {
        return Math.round(1000 * value) / 1000.0;
    }
}
