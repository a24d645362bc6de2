package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import org.phrenic.cli.option.OutputFolder;
import org.phrenic.cli.report.CliNotice;
import org.phrenic.cli.report.LineProgress;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.file.AtomicFile;
import org.phrenic.study.speed.SpeedReport;
import org.phrenic.study.speed.SpeedStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code phrenic bench speed}: the paper's table of iterations a second, and cost against size. */
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
            CliNotice.TEXT
        })
final class BenchSpeedCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Option(
            names = "--quick",
            description = "Low resolution, one thread, two sizes: some seconds; the figures are worth little.")
    private boolean quick;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path out;

    @Option(names = "--json", description = "Print JSON instead of tables.")
    private boolean json;

    @Override
    public Integer call() {
        if (out != null) {
            OutputFolder.requireWritable(out);
        }
        SpeedStudy study = SpeedStudy.of(
                quick ? SpeedStudy.Settings.QUICK : SpeedStudy.Settings.FULL,
                new LineProgress(spec.commandLine().getErr(), "done"));
        SpeedReport report = new SpeedReport(study);
        if (out != null) {
            AtomicFile.write(out.resolve("speed.md"), report.markdown());
            AtomicFile.write(out.resolve("speed.csv"), report.csv());
            JsonWriter.write(out.resolve("speed.json"), report.values());
        }
        PrintWriter stdout = spec.commandLine().getOut();
        stdout.print(
                json
                        ? JsonWriter.format(report.values())
                        : table(report.table()) + "\n" + table(report.ribMotionOverhead()) + "\n"
                                + table(report.scaling()) + "\n" + report.exponent() + "\n" + CliNotice.TEXT + "\n");
        stdout.flush();
        return ExitCode.SUCCESS;
    }

    private static String table(List<List<String>> rows) {
        boolean[] right = new boolean[rows.get(0).size()];
        Arrays.fill(right, 1, right.length, true);
        return new TextTable(right).rows(rows).text();
    }
}
