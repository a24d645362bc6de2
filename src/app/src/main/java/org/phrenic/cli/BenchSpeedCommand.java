package org.phrenic.cli;

import java.nio.file.Path;
import org.phrenic.cli.option.OutputFolder;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.AtomicFile;
import org.phrenic.study.speed.SpeedReport;
import org.phrenic.study.speed.SpeedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * {@code phrenic bench speed}: reproduces the paper's table of iterations per second, and measures cost against size.
 */
@Command(
        name = "speed",
        description = "Measure steps a second by resolution and forces, beside the paper's, and the cost of a step from"
                + " 6,600 to 1.3 million nodes.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench speed --out result        about three minutes",
            "  phrenic bench speed --quick",
            "",
            "DIR gets speed.md, speed.csv and speed.json. Other programs at work make every figure worse.",
            Disclaimer.TEXT
        })
final class BenchSpeedCommand extends ReportingCommand {
    @Option(
            names = "--quick",
            description = "Low resolution, one thread, two sizes: some seconds; the figures are worth little.")
    private boolean quick;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path out;

    @Override
    public Integer call() {
        if (out != null) {
            OutputFolder.requireWritable(out);
        }
        SpeedStudy study =
                SpeedStudy.of(quick ? SpeedStudy.Settings.QUICK : SpeedStudy.Settings.FULL, progress("done"));
        SpeedReport report = new SpeedReport(study);
        if (out != null) {
            AtomicFile.write(out.resolve("speed.md"), report.markdown());
            AtomicFile.write(out.resolve("speed.csv"), report.csv());
            JsonWriter.write(out.resolve("speed.json"), report.values());
        }
        print(
                report.values(),
                () -> withDisclaimer(String.join(
                        "\n",
                        TextTable.ofNumbers(report.table()),
                        TextTable.ofNumbers(report.ribMotionOverhead()),
                        TextTable.ofNumbers(report.scaling()),
                        report.exponent())));
        return ExitCode.SUCCESS;
    }
}
