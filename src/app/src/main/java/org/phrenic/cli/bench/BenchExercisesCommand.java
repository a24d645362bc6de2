package org.phrenic.cli.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RobotOperator;
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
import org.phrenic.file.Numbers;
import org.phrenic.study.Attempts;
import org.phrenic.study.ExerciseReport;
import org.phrenic.study.ExerciseStudy;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic bench exercises}: lets a robot with a known hand do exercises many times. */
@Command(
        name = "exercises",
        description = "Measure how hard exercises are: a robot with a reaction time, the latency of the image and an"
                + " unsteady hand does each many times, breathing freely and with a held breath.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench exercises --set resolution=low --out result        about ten minutes",
            "  phrenic bench exercises data/exercises/2-dome-target.yaml --attempts 20 --set resolution=low",
            "",
            "DIR gets exercises.md and exercises.json. Exit code 3 if an exercise cannot be done, which is named.",
            Disclaimer.TEXT
        })
final class BenchExercisesCommand extends ReportingCommand {
    private static final int MOST_ATTEMPTS = 10_000;

    @Parameters(arity = "0..*", paramLabel = "PLAN", description = "Plans of rehearsals; the exercises without any.")
    private List<Path> plans = new ArrayList<>();

    @Option(
            names = "--attempts",
            paramLabel = "N",
            defaultValue = "50",
            description = "Attempts in either way of breathing (${DEFAULT-VALUE}).")
    private int attempts;

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Sets a value of the scenarios; may be repeated.")
    private List<String> set = new ArrayList<>();

    @Mixin
    private ProvenanceOption provenance;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() {
        out.check();
        if (attempts < 1 || attempts > MOST_ATTEMPTS) {
            throw new BadInputException("--attempts: found " + attempts + ", expected 1 to " + MOST_ATTEMPTS);
        }
        List<RehearsalPlan> exercises = plans.isEmpty()
                ? RehearsalPlan.exercises()
                : plans.stream().map(RehearsalPlan::read).toList();
        List<RehearsalPlan> asked =
                exercises.stream().map(plan -> plan.with(set)).toList();
        Attempts<List<ExerciseStudy.Result>> done = new Attempts<>();
        try (ConsoleProgress progress = progress()) {
            asked.forEach(plan -> done.add(
                    plan.title(), () -> ExerciseStudy.of(plan, RobotOperator.Hand.STANDARD, attempts, progress)));
            done.failures().forEach(progress::note);
        }
        List<ExerciseStudy.Result> results =
                done.results().stream().flatMap(List::stream).toList();
        ExerciseReport report = new ExerciseReport(RobotOperator.Hand.STANDARD, results, done.failures());
        out.write("exercises.md", MarkdownPage.format(report.document(provenance.lines())));
        out.write("exercises.json", report.values());
        print(report.values(), () -> table(results));
        return report.failures().isEmpty() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private String table(List<ExerciseStudy.Result> results) {
        TextTable table =
                new TextTable(Column.list("exercise | breath | # attempts | # hit_percent | # median_error_mm"));
        for (ExerciseStudy.Result r : results) {
            table.row(
                    r.exercise(),
                    r.held() ? "held" : "free",
                    Integer.toString(r.attempts()),
                    Numbers.format("%.0f", 100 * r.hitShare()),
                    Numbers.format("%.1f", r.medianMm()));
        }
        return withDisclaimer(table.text());
    }
}
