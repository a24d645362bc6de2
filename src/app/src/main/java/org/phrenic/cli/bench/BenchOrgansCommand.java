package org.phrenic.cli.bench;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.cli.option.CoarseResolutionOption;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.body.OrganReport;
import org.phrenic.study.body.OrganStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code phrenic bench organs}: volumes and overlaps of the virtual bodies' organs. */
@Command(
        name = "organs",
        description = "Measure the organs of virtual bodies at rest and at full inspiration, quiet and deep: volumes"
                + " against references, overlaps, and how deep any lies in another.",
        footer = {
            "",
            "Example:",
            "  phrenic bench organs --out result        about two minutes",
            "",
            "DIR gets organs.md and organs.json. Exit code 3 if a volume or a pair is beyond a limit.",
            Disclaimer.TEXT
        })
final class BenchOrgansCommand extends ReportingCommand {
    @Parameters(
            arity = "0..*",
            paramLabel = "BODY",
            description = "Virtual bodies, such as virtual/adult-female; all three without any.")
    private List<String> bodies = new ArrayList<>();

    @Mixin
    private CoarseResolutionOption resolution;

    @Mixin
    private ProvenanceOption provenance;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() {
        for (String body : bodies) {
            if (!RunSettings.VIRTUAL_BODIES.contains(body)) {
                throw new BadInputException("found '" + body + "', expected virtual bodies, of "
                        + String.join(", ", RunSettings.VIRTUAL_BODIES));
            }
        }
        out.check();
        Scenario scenario = Scenario.defaults().with(List.of(resolution.assignment()));
        OrganReport report;
        try (ConsoleProgress progress = progress()) {
            report = OrganStudy.of(scenario, bodies.isEmpty() ? RunSettings.VIRTUAL_BODIES : bodies, progress);
        }
        out.write("organs.md", MarkdownPage.format(report.document(provenance.lines())));
        out.write("organs.json", report.values());
        print(report.values(), () -> table(report));
        return report.passes() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private String table(OrganReport report) {
        TextTable table = new TextTable(
                Column.list("body | moment | # pairs | # overlap_percent | of | # depth_mm | of | within"));
        report.table().forEach(row -> table.row(row.toArray(String[]::new)));
        return table.text() + "\n" + withDisclaimer(report.summary() + ".\n");
    }
}
