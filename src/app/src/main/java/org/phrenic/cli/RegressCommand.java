package org.phrenic.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.Numbers;
import org.phrenic.study.regression.Regression;
import org.phrenic.study.regression.RegressionComparison;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code phrenic regress}: recomputes scenes and compares them with stored references. */
@Command(
        name = "regress",
        description = "Compute a list of scenes anew and hold them against their stored references, node by node.",
        footer = {
            "",
            "Examples:",
            "  phrenic regress",
            "  phrenic regress --scene quiet,paper --json",
            "  phrenic regress --write-references data/regression",
            "",
            "Exit code 3 if a scene is farther from its references than its tolerance. The scenes: docs/regression.md."
        })
final class RegressCommand extends ReportingCommand {
    /** Options that are read with --write-references. */
    private static final Set<String> OF_WRITING = Set.of("--write-references", "--scene", "--debug");

    @Option(names = "--scene", paramLabel = "NAME,...", description = "Only these scenes.")
    private String only;

    @Option(
            names = "--references",
            paramLabel = "DIR",
            description = "Folder of references; without it, those that come with the program.")
    private Path references;

    @Option(
            names = "--write-references",
            paramLabel = "DIR",
            description = "Compare nothing: write what the scenes give as references into DIR.")
    private Path write;

    @Override
    public Integer call() {
        List<String> scenes = only == null ? List.of() : OptionValues.split(only);
        ProgressListener progress = progress("scenes done");
        if (write != null) {
            requireRead(OF_WRITING::contains, "with --write-references, which compares and prints nothing");
            new Regression(ReportFolder.requireWritable("--write-references", write)).write(scenes, progress);
            return ExitCode.SUCCESS;
        }
        List<RegressionComparison> comparisons = new Regression(references).check(scenes, progress);
        boolean hold = comparisons.stream().allMatch(RegressionComparison::passes);
        print(values(comparisons, hold), () -> table(comparisons, hold));
        return hold ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private static String table(List<RegressionComparison> comparisons, boolean hold) {
        TextTable table = new TextTable(
                Column.list("scene | verdict | # worst mm | # node | # at s | worst observable | # share | # at s"));
        StringBuilder told = new StringBuilder();
        for (RegressionComparison c : comparisons) {
            table.row(
                    c.scene(),
                    c.passes() ? "holds" : "OFF",
                    number("%.2g", c.worstMm()),
                    c.worstNode() < 0 ? "-" : String.valueOf(c.worstNode()),
                    number("%.3f", c.worstNodeTimeS()),
                    c.worstObservable().isEmpty() ? "-" : c.worstObservable(),
                    number("%.2g", c.worstRelativeError()),
                    number("%.3f", c.worstObservableTimeS()));
            if (!c.passes()) {
                told.append(c.scene()).append(": ").append(c.sentence()).append('\n');
            }
        }
        return table.text() + told + (hold ? "passed" : "failed") + "\n";
    }

    private static String number(String format, double value) {
        return Double.isNaN(value) ? "-" : Numbers.format(format, value);
    }

    private static Map<String, Object> values(List<RegressionComparison> comparisons, boolean hold) {
        List<OrderedValues> scenes =
                comparisons.stream().map(RegressCommand::values).toList();
        return new OrderedValues().with("passes", hold).with("scenes", scenes);
    }

    private static OrderedValues values(RegressionComparison c) {
        OrderedValues values = new OrderedValues()
                .with("scene", c.scene())
                .with("holds", c.passes())
                .with("worst_mm", c.worstMm())
                .with("worst_node", c.worstNode())
                .with("worst_node_time_s", c.worstNodeTimeS())
                .with("worst_observable", c.worstObservable())
                .with("worst_share", c.worstRelativeError())
                .with("worst_observable_time_s", c.worstObservableTimeS())
                .with("sentence", c.sentence());
        values.values().removeIf(value -> value instanceof Double number && !Double.isFinite(number));
        return values;
    }
}
