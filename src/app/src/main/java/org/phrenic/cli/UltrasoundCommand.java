package org.phrenic.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.access.ultrasound.BModeImage;
import org.phrenic.access.ultrasound.ProbeOnSkin;
import org.phrenic.access.ultrasound.SonatedNeedle;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.cli.option.ProbeOptions;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.option.ScenarioOptions;
import org.phrenic.cli.option.TimeOptions;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.Numbers;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.ScenePlayer;
import org.phrenic.scene.UltrasoundPicture;
import org.phrenic.simulation.observe.Frame;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic ultrasound}: writes B-mode images of the breathing body from a probe on its skin. */
@Command(
        name = "ultrasound",
        description = "Take ultrasound images of the breathing body with a probe on its skin; needs no display.",
        footer = {
            "",
            "Examples:",
            "  phrenic ultrasound --out images",
            "  phrenic ultrasound --skin right-subcostal --rotate 90 --tilt 40 --at 0,1,2 --out images",
            "  phrenic ultrasound patient.yaml --skin -120,-40,30 --frames 40 --depth 180 --out images",
            "",
            "DIR gets ultrasound_0001.png and so on, 512 x 512 pixels, and ultrasound.json with the pose of the probe.",
            "",
            Disclaimer.TEXT
        })
final class UltrasoundCommand extends ReportingCommand {
    private static final String REPORT = "ultrasound.json";

    @Mixin
    private ScenarioOptions scenarioOptions;

    @Mixin
    private ProbeOptions probeOptions;

    @Mixin
    private TimeOptions timeOptions;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "Folder for the images.")
    private Path out;

    private final List<OrderedValues> written = new ArrayList<>();
    private List<String> leftOut = List.of();

    @Override
    public Integer call() {
        timeOptions.validate();
        probeOptions.validate();
        ReportFolder.requireWritable(out);
        Scenario scenario = scenarioOptions.resolved();
        try (ConsoleProgress progress = progress();
                ScenePlayer player = new ScenePlayer(scenario, progress)) {
            double[] times = timeOptions.times(player.durationS());
            ProbeOnSkin place = probeOptions.place(player.surfaces());
            Ultrasound ultrasound = new Ultrasound(player.surfaces(), probeOptions.probe(), scenario.threads());
            leftOut = ultrasound.leftOut();
            if (!leftOut.isEmpty()) {
                progress.note("Not in the images, as they are open: " + String.join(", ", leftOut) + ".");
            }
            AtomicFile.delete(out.resolve(REPORT));
            for (double time : times) {
                Frame frame = player.advanceTo(time);
                BModeImage image = ultrasound.take(
                        frame,
                        place.pose(frame, probeOptions.angles()),
                        probeOptions.settings(),
                        probeOptions.needle());
                String file = Numbers.format("ultrasound_%04d.png", written.size() + 1);
                UltrasoundPicture.write(out.resolve(file), image);
                list(file, frame.timeS(), image);
            }
        }
        OrderedValues report = report(scenario);
        JsonWriter.write(out.resolve(REPORT), report);
        print(report, this::table);
        return ExitCode.SUCCESS;
    }

    private void list(String file, double timeS, BModeImage image) {
        OrderedValues values = new OrderedValues()
                .with("file", file)
                .with("time_s", timeS)
                .with("face_mm", numbers(image.pose().face()))
                .with("axial", numbers(image.pose().axial()))
                .with("lateral", numbers(image.pose().lateral()))
                .with("mm_per_pixel", image.mmPerPixel());
        Optional<SonatedNeedle> needle = probeOptions.needle();
        needle.ifPresent(n -> values.with(
                        "needle_in_beam_mm",
                        n.lengthInBeamMm(
                                image.probe(), image.pose(), image.settings().depthMm()))
                .with(
                        "tip_in_beam",
                        n.isTipInBeam(
                                image.probe(), image.pose(), image.settings().depthMm())));
        written.add(values);
    }

    private static List<Double> numbers(double[] values) {
        return Arrays.stream(values).boxed().toList();
    }

    private OrderedValues report(Scenario scenario) {
        OrderedValues report = new OrderedValues()
                .with("scenario", scenario.name())
                .with("anatomy", scenario.anatomy())
                .with("frequency_mhz", probeOptions.probe().frequencyMhz())
                .with("focus_mm", probeOptions.probe().focusMm())
                .with("thickness_mm", probeOptions.probe().thicknessMm())
                .with("depth_mm", probeOptions.settings().depthMm())
                .with("gain_db", probeOptions.settings().gainDb())
                .with("depth_gain_db_per_cm_mhz", probeOptions.settings().depthGainDbPerCmMhz())
                .with("dynamic_range_db", probeOptions.settings().dynamicRangeDb())
                .with("images", written);
        if (!leftOut.isEmpty()) {
            report.put("left_out", leftOut);
        }
        return report.with("notice", Disclaimer.TEXT);
    }

    private String table() {
        TextTable table = new TextTable(Column.list("file | # time_s | # face_mm"));
        for (OrderedValues row : written) {
            List<?> face = (List<?>) row.get("face_mm");
            table.row(
                    row.get("file").toString(),
                    Numbers.format("%.3f", (Double) row.get("time_s")),
                    face.stream().map(mm -> Numbers.format("%.1f", (Double) mm)).collect(Collectors.joining(", ")));
        }
        return withDisclaimer(table.text());
    }
}
