package org.phrenic.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.phrenic.anatomy.Thorax;
import org.phrenic.breathing.pattern.TracePattern;
import org.phrenic.cli.option.MotionOptions;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.option.ScenarioOptions;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.file.Numbers;
import org.phrenic.file.UserCache;
import org.phrenic.mesh.io.raster.VolumeSource;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.motion.BodyMotion;
import org.phrenic.motion.MotionExport;
import org.phrenic.motion.MotionRequest;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.ScheduleCheck;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic motion}: writes where every point of a breathing body goes. */
@Command(
        name = "motion",
        description = "Write where every point of the breathing body goes: displacement fields, trajectories, images.",
        footer = {
            "",
            "Examples:",
            "  phrenic motion --grid 5mm --phases 4 --out fields",
            "  phrenic motion --preset deep --points landmarks.csv --phases 20 --out tracks",
            "  phrenic motion patient.yaml --warp ct.nii.gz --phases 10 --jacobian --out breathing",
            "",
            "DIR gets motion.json, which lists the files. Places are those at end-expiration: docs/motion.md.",
            "",
            Disclaimer.TEXT
        })
final class MotionCommand extends ReportingCommand {
    private static final String POINTS_OFF = "points_off_mean_mm";
    /** Regular expression of the name, up to the extension, of a file that holds one time. */
    private static final String FILE_OF_A_TIME = ".+_(at|to)_\\d+\\.\\d{3}s\\.";

    @Mixin
    private ScenarioOptions scenarioOptions;

    @Mixin
    private MotionOptions options;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "Folder for the files.")
    private Path out;

    @Override
    public Integer call() {
        // The request reads the table of times, which these trajectories would replace.
        requireKept(options.timesFile());
        MotionRequest request = options.request();
        ReportFolder.requireWritable(out);
        requireInputsKept(request);
        Scenario scenario = scenarioOptions.resolved();
        ConsoleProgress progress = progress();
        ScheduleCheck.require(scenario);
        requireSimulatedTimes(scenario);
        OrderedValues report;
        Thorax thorax = SimulationRun.loadThorax(scenario);
        thorax.notes().forEach(progress::note);
        try (Simulation simulation = Simulation.of(scenario, thorax, UserCache.ofUser(), progress)) {
            double lastS = Math.max(simulation.stepTimes().lastS(), simulation.durationS());
            // Wrong times are refused before the body is divided into regions, which takes longer.
            double[] times = options.times(simulation.breathDurationS(), lastS);
            try (BodyMotion motion =
                    new BodyMotion(simulation, options.organs(), options.lungs(), scenario.threads())) {
                report = new MotionExport(simulation, motion, request, out, progress).write(times);
            }
        } finally {
            progress.end();
        }
        print(report, () -> table(report));
        return ExitCode.SUCCESS;
    }

    /** Refuses to write the trajectories over a table. */
    private void requireKept(Path table) {
        ReportFolder.requireNotRead("--out", out.resolve("trajectories.csv"), table);
    }

    /** Refuses to write over the points or the image. */
    private void requireInputsKept(MotionRequest request) {
        requireKept(request.points());
        if (request.image() == null) {
            return;
        }
        Path image = VolumeSource.of(request.image()).path();
        ReportFolder.requireNotRead("--out", out.resolve("warped." + request.format()), image);
        String name = String.valueOf(image.getFileName());
        if (name.matches(FILE_OF_A_TIME + Pattern.quote(request.format()))) {
            ReportFolder.requireNotRead("--out", out.resolve(name), image);
        }
    }

    /**
     * Refuses the times of the recording that is breathed: those of the simulation begin at an end-expiration of it.
     */
    private void requireSimulatedTimes(Scenario scenario) {
        Path times = options.timesFile();
        if (times != null
                && scenario.trace()
                        .filter(trace -> FileNames.isSamePlace(trace, times))
                        .isPresent()
                && Breathing.patternOf(scenario) instanceof TracePattern trace
                && trace.startS() != 0) {
            throw new BadInputException(Numbers.format(
                    "--times %s: found the recording that is breathed, expected simulated times, of which 0 is at"
                            + " %.3f s of the recording",
                    times, trace.startS()));
        }
    }

    private static String table(OrderedValues report) {
        List<?> phases = (List<?>) report.get("phases");
        boolean seen = phases.stream().anyMatch(phase -> ((Map<?, ?>) phase).containsKey(POINTS_OFF));
        TextTable table = new TextTable(true, true, true, true)
                .row("time_s", "error_mean_mm", "error_99%_mm", seen ? "points_off_mm" : "");
        for (Object phase : phases) {
            Map<?, ?> values = (Map<?, ?>) phase;
            table.row(
                    number(values.get("time_s")),
                    number(values.get("lattice_error_mean_mm")),
                    number(values.get("lattice_error_percentile_99_mm")),
                    seen ? number(values.get(POINTS_OFF)) : "");
        }
        String files = String.join(
                "\n",
                ((List<?>) report.get("files")).stream().map(String::valueOf).toList());
        return withDisclaimer(table.text() + "\n" + files + "\n");
    }

    private static String number(Object value) {
        return Numbers.format("%.3f", (Double) value);
    }
}
