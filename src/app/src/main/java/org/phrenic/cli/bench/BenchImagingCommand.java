package org.phrenic.cli.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.Attempts;
import org.phrenic.study.access.ImagingReport;
import org.phrenic.study.access.ImagingStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic bench imaging}: time of ultrasound images and radiographs. */
@Command(
        name = "imaging",
        description = "Measure how long radiographs and ultrasound images of 512 x 512 pixels take, ultrasound also"
                + " beside the scene that runs at the pace of the clock.",
        footer = {
            "",
            "Example:",
            "  phrenic bench imaging --out result        about a minute",
            "",
            "DIR gets imaging.md and imaging.json. Other programs at work make every figure worse.",
            "Exit code 3 if a body cannot be imaged, which is named.",
            Disclaimer.TEXT
        })
final class BenchImagingCommand extends ReportingCommand {
    private static final double LEAST_S = 0.1;
    private static final double MOST_S = 600;

    @Parameters(
            arity = "0..*",
            paramLabel = "BODY",
            description = "Bodies, such as virtual/adult-female or a folder; the virtual man and woman without any.")
    private List<String> bodies = new ArrayList<>();

    @Option(
            names = "--seconds",
            paramLabel = "S",
            description = "Wall time beside the running scene of each body (${DEFAULT-VALUE}).")
    private String seconds = "10";

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Sets a value of the scenario; may be repeated.")
    private List<String> set = new ArrayList<>();

    @Mixin
    private ProvenanceOption provenance;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() {
        out.check();
        double wallS = OptionValues.number("--seconds", seconds, LEAST_S, MOST_S);
        Scenario scenario =
                Scenario.defaults().with(OptionValues.assignments(set, Set.of("anatomy"), "each BODY of the command"));
        List<String> measured = bodies.isEmpty() ? List.of(RunSettings.VIRTUAL_MAN, RunSettings.VIRTUAL_WOMAN) : bodies;
        List<Scenario> asked = measured.stream()
                .map(body -> scenario.with(List.of(Assignment.read(body, "anatomy", body))))
                .toList();
        Attempts<ImagingStudy.Result> results = new Attempts<>();
        asked.forEach(body -> results.add(body.anatomy(), () -> ImagingStudy.of(body, wallS)));
        ImagingReport report = new ImagingReport(scenario, results.results(), results.failures());
        out.write("imaging.md", MarkdownPage.format(report.document(provenance.lines())));
        out.write("imaging.json", report.values());
        print(report.values(), () -> table(report));
        report.failures().forEach(err()::println);
        return report.failures().isEmpty() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private String table(ImagingReport report) {
        TextTable table =
                new TextTable(Column.list("body | # triangles | # xray_ms | # xray_p95 | # alone_ms | # beside_ms"
                        + " | # beside_p95 | # images_per_s | # realtime | within"));
        report.table().forEach(row -> table.row(row.toArray(String[]::new)));
        return table.text() + "\n" + withDisclaimer(report.summary() + ".\n");
    }
}
