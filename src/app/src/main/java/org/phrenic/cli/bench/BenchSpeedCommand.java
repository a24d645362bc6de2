package org.phrenic.cli.bench;

import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.study.speed.SpeedReport;
import org.phrenic.study.speed.SpeedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
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

    @Mixin
    private ProvenanceOption provenance;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() {
        out.check();
        SpeedStudy.Settings settings = quick ? SpeedStudy.Settings.QUICK : SpeedStudy.Settings.FULL;
        SpeedReport report = new SpeedReport(SpeedStudy.of(settings, progress("done")));
        out.write("speed.md", MarkdownPage.format(report.document(provenance.lines())));
        out.write("speed.csv", report.csv());
        out.write("speed.json", report.values());
        print(report.values(), () -> {
            String speed = TextTable.ofNumbers(report.table());
            String overhead = TextTable.ofNumbers(report.ribMotionOverhead());
            String scaling = TextTable.ofNumbers(report.scaling());
            return withDisclaimer(String.join("\n", speed, overhead, scaling, report.exponent()));
        });
        return ExitCode.SUCCESS;
    }
}
