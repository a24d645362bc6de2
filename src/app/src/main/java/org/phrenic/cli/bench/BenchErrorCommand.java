package org.phrenic.cli.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.phrenic.cli.chart.BudgetChart;
import org.phrenic.cli.chart.ErrorChart;
import org.phrenic.cli.option.ErrorBudgetOptions;
import org.phrenic.cli.option.MeasuredTableOption;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Hashes;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.study.error.BudgetReport;
import org.phrenic.study.error.ErrorReport;
import org.phrenic.study.error.ErrorStudy;
import org.phrenic.study.error.ErrorTable;
import org.phrenic.study.error.MeshRefinementError;
import org.phrenic.study.error.SolverGrid;
import org.phrenic.study.error.TableCheck;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic bench error}: measures cost and error of solver settings against a reference. */
@Command(
        name = "error",
        description = "Measure speed against error: one breath under many settings, held against a reference.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench error --quick",
            "  phrenic bench error --resolution high --out result",
            "  phrenic bench error --material physical --integrator verlet,rk4 --sweeps 1,2,4 --max-error 0.02",
            "",
            "DIR gets error.csv, error.md, error.json and error.png. At low resolution with --until 2, the settings",
            "of the paper's material take half a minute of processor time, those of the physical one 75 s.",
            Disclaimer.TEXT
        })
final class BenchErrorCommand extends ReportingCommand {
    /** Scenario keys that the command sets. */
    private static final Set<String> RESERVED = Set.of(
            "material",
            "resolution",
            "integrator",
            "time_step_s",
            "projection_sweeps",
            "refresh_s",
            "threads",
            "duration_s",
            "steps",
            "changes",
            "hold",
            "meshes_every_s");

    /** Options that are read with --whole. */
    private static final Set<String> OF_WHOLE = Set.of(
            "--whole",
            "--part",
            "--scan",
            "--beside",
            "--resolution",
            "--quick",
            "--out",
            "--made-by",
            "--json",
            "--debug");

    /** Options that are read with --whole alone. */
    private static final Set<String> OF_WHOLE_ALONE = Set.of("--part", "--scan", "--beside");

    /** Options that --quick, whose body, mesh and time are its own, does not read or cannot fill a table for. */
    private static final Set<String> NOT_QUICK = Set.of("--resolution", "--scan", "--beside", "--write");

    /** Options that are read with --check. */
    private static final Set<String> OF_CHECK = Set.of("--check", "--debug");

    private static final int CHECKED_ROWS = 6;

    @Option(
            names = "--material",
            paramLabel = "NAME,...",
            description = "physical, paper or both (default ${DEFAULT-VALUE}).")
    private String materials = "physical,paper";

    @Option(
            names = "--resolution",
            paramLabel = "NAME,...",
            description = "low, medium, high (default medium, with --whole all three).")
    private String resolutions;

    @Option(names = "--integrator", paramLabel = "NAME,...", description = "Only these schemes.")
    private String integrators;

    @Option(names = "--time-step", paramLabel = "S,...", description = "These steps; each divides 0.1 s.")
    private String timeSteps;

    @Option(names = "--sweeps", paramLabel = "N,...", description = "These sweeps over all constraints a step.")
    private String sweeps;

    @Option(names = "--refresh", paramLabel = "S,...", description = "These times between wall planes taken anew.")
    private String refreshes;

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Any other key of a scenario; may be repeated.")
    private List<String> settings = new ArrayList<>();

    @Option(names = "--threads", paramLabel = "N", description = "Threads of each run (default ${DEFAULT-VALUE}).")
    private String threads = "1";

    @Option(
            names = "--quick",
            description = "The sheet alone, low resolution, few settings, a part of a breath: seconds.")
    private boolean quick;

    @Option(names = "--meshes", description = "Also what low and medium resolution change against high.")
    private boolean meshes;

    @Option(
            names = "--max-error",
            paramLabel = "MM",
            description = "Also say which setting is the cheapest that keeps this rms error of the diaphragm.")
    private String maxError;

    @Option(
            names = "--until",
            paramLabel = "S",
            description = "Simulated time instead of a whole breath; the distance from equilibrium is left out.")
    private String until;

    @Option(
            names = "--check",
            paramLabel = "FILE",
            description = "Instead: measure six rows of a table again, drawn by its hash; exit code 3 if one is off by"
                    + " more than 25 %%.")
    private Path check;

    @Mixin
    private ErrorBudgetOptions budget;

    @Mixin
    private ProvenanceOption provenance;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder for the reports.")
    private Path out;

    @Mixin
    private MeasuredTableOption table;

    @Override
    public Integer call() {
        requireUsed();
        if (out != null) {
            ReportFolder.requireWritable(out);
        } else {
            requireRead(name -> !name.equals("--made-by"), "without --out, expected both");
        }
        table.requireWritable();
        if (budget.isGiven()) {
            return measureBudget();
        }
        if (check != null) {
            return checkTable();
        }
        if (until != null) {
            simulatedS();
        }
        double most = maxError == null ? Double.NaN : OptionValues.number("--max-error", maxError, 1e-9, 1e3);
        List<Scenario> scenarios = scenarios();
        scenarios.forEach(this::grid);
        table.open(
                OptionValues.assignments(settings, RESERVED, "the measurement"),
                scenarios,
                integrators == null && timeSteps == null && sweeps == null && refreshes == null,
                scenario -> until == null ? ErrorStudy.breathS(scenario) : simulatedS());
        if (!quick && integrators == null && timeSteps == null) {
            progress().note("All settings take minutes of processor time; --quick takes half a minute.");
        }
        ProgressListener progress = progress();
        List<ErrorStudy> studies = new ArrayList<>();
        for (Scenario scenario : scenarios) {
            studies.add(
                    until == null
                            ? ErrorStudy.of(scenario, grid(scenario), quick, progress)
                            : ErrorStudy.of(scenario, grid(scenario), simulatedS(), false, progress));
        }
        ErrorTable measured = ErrorTable.of(studies);
        ErrorReport report = new ErrorReport(studies, meshes ? meshErrors(scenarios, progress) : Map.of());
        if (out != null) {
            write(measured, report);
        }
        table.put(measured);
        Stream<Scenario> asked = Double.isNaN(most) ? Stream.empty() : scenarios.stream();
        List<String> cheapest =
                asked.map(s -> ErrorReport.cheapestSentence(measured, s, most)).toList();
        print(report.values(), () -> text(studies, report, cheapest));
        if (isJson()) {
            cheapest.forEach(err()::println);
        }
        return ExitCode.SUCCESS;
    }

    /** Refuses an option that the kind of measurement does not read. */
    private void requireUsed() {
        if (quick) {
            requireRead(
                    name -> !NOT_QUICK.contains(name),
                    "with --quick, which measures a coarse sheet for a moment, expected one of the two");
        }
        if (budget.isGiven()) {
            requireRead(
                    OF_WHOLE::contains,
                    "with --whole, which measures the defaults; a scenario given by --beside is measured beside them");
            return;
        }
        requireRead(name -> !OF_WHOLE_ALONE.contains(name), "without --whole, expected both");
        if (check != null) {
            requireRead(OF_CHECK::contains, "with --check, which measures rows of the table alone");
        }
    }

    private double simulatedS() {
        return OptionValues.number("--until", until, 0.1, 1e3);
    }

    private int checkTable() {
        ErrorTable stated = ErrorTable.read(check);
        if (stated.rows().isEmpty()) {
            throw new BadInputException("--check " + check + ": found no row, expected rows to measure again");
        }
        List<TableCheck> checks =
                TableCheck.measure(TableCheck.draw(stated, Hashes.sha256(check), CHECKED_ROWS, row -> true), false);
        checks.forEach(c -> out().println(c.sentence()));
        return checks.stream().allMatch(TableCheck::holds) ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private int measureBudget() {
        String names = resolutions == null ? "low,medium,high" : resolutions;
        BudgetReport report = budget.measure(names, quick, out, progress("measured"));
        if (out != null) {
            System.setProperty("java.awt.headless", "true");
            boolean drawn = !report.charted().isEmpty() && Annotations.hasFonts();
            if (drawn) {
                BudgetChart.write(report.charted(), out.resolve("error.png"));
            }
            writePages(out, "error", report.document(provenance.lines(), drawn ? "error.png" : ""));
            JsonWriter.write(out.resolve("error.json"), report.values());
        }
        print(
                report.values(),
                () -> withDisclaimer(new TextTable(BudgetReport.COLUMNS)
                        .rows(report.cells(false))
                        .text()));
        return ExitCode.SUCCESS;
    }

    private static Map<String, List<MeshRefinementError>> meshErrors(
            List<Scenario> scenarios, ProgressListener progress) {
        Map<String, List<MeshRefinementError>> errors = new LinkedHashMap<>();
        for (Scenario scenario : scenarios) {
            errors.computeIfAbsent(scenario.material().label(), m -> ErrorStudy.meshes(scenario, progress));
        }
        return errors;
    }

    private List<Scenario> scenarios() {
        List<Assignment> more = OptionValues.assignments(settings, RESERVED, "the measurement");
        List<Scenario> scenarios = new ArrayList<>();
        for (String material : OptionValues.split(materials)) {
            for (String resolution :
                    quick ? List.of("low") : OptionValues.split(resolutions == null ? "medium" : resolutions)) {
                List<Assignment> list = new ArrayList<>();
                OptionValues.assign(list, "--material", "material", material);
                OptionValues.assign(list, "--resolution", "resolution", resolution);
                list.add(Assignment.of("--threads", Numerics.THREADS, OptionValues.threads(threads, 1)));
                if (quick) {
                    list.add(Assignment.read("--quick", "lungs", "embedded"));
                    list.add(Assignment.read("--quick", "sternum", "kinematic"));
                }
                list.addAll(more);
                scenarios.add(Scenario.defaults().with(list));
            }
        }
        return scenarios;
    }

    /** The grid of settings to measure: option values where given, otherwise the defaults of the material. */
    private SolverGrid grid(Scenario scenario) {
        SolverGrid usual = quick ? SolverGrid.quick(scenario.material()) : SolverGrid.of(scenario.material());
        return new SolverGrid(
                OptionValues.integrators(integrators, usual.integrators()),
                values(timeSteps, usual.timeStepsS(), n -> OptionValues.number("--time-step", n, 1e-5, 0.1)),
                values(sweeps, usual.sweeps(), n -> OptionValues.integer("--sweeps", n, 1, 100)),
                values(refreshes, usual.refreshesS(), n -> OptionValues.number("--refresh", n, 1e-5, 1)),
                usual.isCrossed() || integrators != null || timeSteps != null || sweeps != null || refreshes != null);
    }

    private static <T> List<T> values(String text, List<T> usual, Function<String, T> parser) {
        return text == null
                ? usual
                : OptionValues.split(text).stream().map(parser).toList();
    }

    private void write(ErrorTable measured, ErrorReport report) {
        measured.write(out.resolve("error.csv"));
        AtomicFile.write(out.resolve("error.md"), MarkdownPage.format(report.document(provenance.lines())));
        JsonWriter.write(out.resolve("error.json"), report.values());
        System.setProperty("java.awt.headless", "true");
        if (Annotations.hasFonts()) {
            ErrorChart.write(measured, "Speed against error", out.resolve("error.png"));
        } else {
            err().println("This Java has no fonts: no chart is drawn.");
        }
    }

    private String text(List<ErrorStudy> studies, ErrorReport report, List<String> cheapest) {
        StringBuilder text = new StringBuilder();
        for (ErrorStudy study : studies) {
            text.append(ErrorReport.heading(study)).append("\n\n");
            text.append(new TextTable(ErrorReport.COLUMNS)
                    .rows(ErrorReport.cells(study))
                    .text());
            study.equilibrium().forEach(q -> text.append(ErrorReport.lagSentence(study, q) + "\n"));
            study.skipped().forEach(line -> text.append("not run: " + line + "\n"));
            text.append('\n');
        }
        report.meshSentences().forEach(line -> text.append(line + "\n"));
        cheapest.forEach(line -> text.append(line + "\n"));
        return text + Disclaimer.TEXT + "\n";
    }
}
