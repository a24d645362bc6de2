package org.phrenic.cli.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.access.plan.RehearsalPlan;
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
import org.phrenic.study.Attempts;
import org.phrenic.study.access.AccessReport;
import org.phrenic.study.access.AccessStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic bench access}: access maps of exercises, their free ways tried by brute force, and their plans. */
@Command(
        name = "access",
        description = "Play exercises as shipped: where their targets can be reached from, whether any free way crosses"
                + " a triangle of what it avoids, and what came of the plans.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench access --set resolution=low --out result        about three minutes",
            "  phrenic bench access data/exercises/2-dome-target.yaml --set resolution=low",
            "",
            "DIR gets access.md and access.json. Exit code 3 if a free way crosses anything or begins on a cut end,",
            "or if an exercise cannot be played, which is named; the others are.",
            Disclaimer.TEXT
        })
final class BenchAccessCommand extends ReportingCommand {
    private static final int MOST_MAPS = 1000;

    @Parameters(arity = "0..*", paramLabel = "PLAN", description = "Plans of rehearsals; the exercises without any.")
    private List<Path> plans = new ArrayList<>();

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Sets a value of the scenarios; may be repeated.")
    private List<String> set = new ArrayList<>();

    @Option(
            names = "--maps",
            paramLabel = "N",
            defaultValue = "3",
            description = "Access maps of each exercise that are timed (${DEFAULT-VALUE}; 0: none).")
    private int maps;

    @Mixin
    private ProvenanceOption provenance;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() {
        out.check();
        if (maps < 0 || maps > MOST_MAPS) {
            throw new BadInputException("--maps: found " + maps + ", expected 0 to " + MOST_MAPS);
        }
        List<RehearsalPlan> exercises = plans.isEmpty()
                ? RehearsalPlan.exercises()
                : plans.stream().map(RehearsalPlan::read).toList();
        List<RehearsalPlan> asked =
                exercises.stream().map(plan -> plan.with(set)).toList();
        Attempts<AccessStudy.Result> results = new Attempts<>();
        try (ConsoleProgress progress = progress()) {
            asked.forEach(plan -> results.add(plan.title(), () -> AccessStudy.of(plan, maps, progress)));
            results.failures().forEach(progress::note);
        }
        AccessReport report = new AccessReport(results.results(), results.failures());
        out.write("access.md", MarkdownPage.format(report.document(provenance.lines())));
        out.write("access.json", report.values());
        print(report.values(), () -> table(report));
        return report.passes() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private String table(AccessReport report) {
        TextTable table = new TextTable(
                Column.list("exercise | # in_reach | # without_organs | # free | # percent | # in_part | # pleura"
                        + " | # ways | # crossing | # on_cut_end | # map_s"));
        report.table().forEach(row -> table.row(row.toArray(String[]::new)));
        StringBuilder text = new StringBuilder(table.text());
        report.failures()
                .forEach(failure -> text.append("not played: ").append(failure).append(".\n"));
        return text + "\n" + withDisclaimer(report.summary() + ".\n");
    }
}
