package org.phrenic.cli.bench;

import java.util.List;
import java.util.Optional;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.stability.StabilityReport;
import org.phrenic.study.stability.StabilityStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic bench stability}: runs demanding cases with every integrator. */
@Command(
        name = "stability",
        description = "Run scenes chosen to break a simulation: each must stay stable, be noticed and recovered, or be"
                + " refused.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench stability --quick",
            "  phrenic bench stability --out result                    the long version: many hours",
            "  phrenic bench stability --only published,sliders --integrator verlet,rk2",
            "",
            "DIR gets stability.md, stability.csv and stability.json. Exit code 3 if a cell fails in silence or a body",
            "does not return. With --quick 20 minutes of processor time; without, many hours, of which each case of an",
            "hour takes about one. Progress says how much time is left.",
            "The cases: docs/stability.md."
        })
final class BenchStabilityCommand extends ReportingCommand {
    private static final double MAX_SPEND = 1e15;

    @Option(names = "--quick", description = "Shorter times on coarser meshes: 20 minutes of processor time.")
    private boolean quick;

    @Option(
            names = "--scan",
            paramLabel = "FOLDER",
            description = "Thorax folder of a scanned body: also its cases thorax-scanned, -deep and -paper.")
    private String scan;

    @Option(names = "--only", paramLabel = "CASE,...", description = "Only these cases.")
    private String only;

    @Option(names = "--integrator", paramLabel = "NAME,...", description = "Only these integrators.")
    private String integrators;

    @Option(
            names = "--spend",
            paramLabel = "N",
            description = "Evaluations of the force on a node that a cell may spend before it ends early"
                    + " (default 5e8, for verlet 6e10; with --quick 4e7).")
    private String spend;

    @Option(names = "--threads", paramLabel = "N", description = "Cases at a time; the numbers do not depend on it.")
    private String threads;

    @Mixin
    private ProvenanceOption provenance;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() {
        out.check();
        StabilityStudy.Settings settings = settings();
        if (!quick && only == null) {
            progress().note("All cells take many hours of processor time; --quick takes 20 minutes.");
        }
        StabilityStudy study = StabilityStudy.of(settings, progress("cells done"));
        StabilityReport report = new StabilityReport(study);
        out.write("stability.md", MarkdownPage.format(report.document(provenance.lines())));
        out.write("stability.csv", report.csv());
        out.write("stability.json", report.values());
        boolean[] leftAligned = new boolean[report.table().get(0).size()];
        TextTable table = new TextTable(leftAligned).rows(report.table());
        print(report.values(), () -> table.text() + "\n" + report.summary() + "\n");
        return study.passes() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private StabilityStudy.Settings settings() {
        StabilityStudy.Settings usual = quick ? StabilityStudy.Settings.QUICK : StabilityStudy.Settings.LONG;
        Optional<String> scanned = Optional.ofNullable(scan);
        scanned.ifPresent(folder -> Assignment.read("--scan " + folder, "anatomy", folder));
        List<String> cases = OptionValues.names("--only", only, StabilityStudy.caseKeys(scanned));
        List<IntegratorKind> kinds = OptionValues.integrators(integrators, usual.integrators());
        int atATime = OptionValues.threads(threads, Scenario.defaults().threads());
        StabilityStudy.Settings settings =
                usual.only(cases, kinds).withThreads(atATime).withScan(scanned);
        return spend == null ? settings : settings.withEvaluations(OptionValues.number("--spend", spend, 1, MAX_SPEND));
    }
}
