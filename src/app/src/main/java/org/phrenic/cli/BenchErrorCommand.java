package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import org.phrenic.cli.chart.ErrorChart;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.OutputFolder;
import org.phrenic.cli.report.CliNotice;
import org.phrenic.cli.report.LineProgress;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.study.error.ErrorReport;
import org.phrenic.study.error.ErrorStudy;
import org.phrenic.study.error.ErrorTable;
import org.phrenic.study.error.MeshRefinementError;
import org.phrenic.study.error.SolverGrid;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code phrenic bench error}: what settings cost and how far from a reference they are. */
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
            "DIR gets error.csv, error.md, error.json and error.png. Without --quick it takes minutes (docs/error.md).",
            CliNotice.TEXT
        })
final class BenchErrorCommand implements Callable<Integer> {
    /** What the command itself decides on. */
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

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--material",
            paramLabel = "NAME,...",
            description = "physical, paper or both (default ${DEFAULT-VALUE}).")
    private String materials = "physical,paper";

    @Option(
            names = "--resolution",
            paramLabel = "NAME,...",
            description = "low, medium, high (default ${DEFAULT-VALUE}).")
    private String resolutions = "medium";

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

    @Option(names = "--out", paramLabel = "DIR", description = "Folder for the reports.")
    private Path out;

    @Option(
            names = "--write",
            paramLabel = "FILE",
            description =
                    "Table to put the rows into, such as data/error/settings.csv, from which run --max-error chooses.")
    private Path table;

    @Option(names = "--json", description = "Print JSON instead of tables.")
    private boolean json;

    @Override
    public Integer call() {
        if (out != null) {
            OutputFolder.requireWritable(out);
        }
        double most = maxError == null ? Double.NaN : OptionValues.number("--max-error", maxError, 1e-9, 1e3);
        ErrorTable earlier = table != null && Files.exists(table) ? ErrorTable.read(table) : null;
        List<Scenario> scenarios = scenarios();
        scenarios.forEach(this::grid);
        ProgressListener progress = new LineProgress(spec.commandLine().getErr());
        List<ErrorStudy> studies = new ArrayList<>();
        for (Scenario scenario : scenarios) {
            studies.add(ErrorStudy.of(scenario, grid(scenario), quick, progress));
        }
        ErrorTable measured = ErrorTable.of(studies);
        ErrorReport report = new ErrorReport(studies, meshes ? meshErrors(scenarios, progress) : Map.of());
        if (out != null) {
            write(measured, report);
        }
        if (table != null) {
            (earlier == null ? measured : earlier.with(measured)).write(table);
        }
        print(studies, measured, report, scenarios, most);
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
        List<Assignment> more = new ArrayList<>();
        for (String text : settings) {
            Assignment assignment = Assignment.parse(text);
            if (RESERVED.contains(assignment.key())) {
                throw new BadInputException(
                        assignment.origin() + ": found a key that the measurement sets itself, expected any other key");
            }
            more.add(assignment);
        }
        List<Scenario> scenarios = new ArrayList<>();
        for (String material : OptionValues.split(materials)) {
            for (String resolution : quick ? List.of("low") : OptionValues.split(resolutions)) {
                List<Assignment> list = new ArrayList<>(List.of(
                        Assignment.read("--material " + material, "material", material),
                        Assignment.read("--resolution " + resolution, "resolution", resolution),
                        Assignment.read(
                                "--threads",
                                "threads",
                                Integer.toString(
                                        OptionValues.integer("--threads", threads, 1, Numerics.MAX_THREADS)))));
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

    /** The settings to measure: those of the material, but for the lists that are given. */
    private SolverGrid grid(Scenario scenario) {
        SolverGrid usual = quick ? SolverGrid.quick(scenario.material()) : SolverGrid.of(scenario.material());
        return new SolverGrid(
                integrators == null
                        ? usual.integrators()
                        : OptionValues.split(integrators).stream()
                                .map(IntegratorKind::of)
                                .toList(),
                timeSteps == null ? usual.timeStepsS() : numbers("--time-step", timeSteps, 0.1),
                sweeps == null
                        ? usual.sweeps()
                        : OptionValues.split(sweeps).stream()
                                .map(n -> OptionValues.integer("--sweeps", n, 1, 100))
                                .toList(),
                refreshes == null ? usual.refreshesS() : numbers("--refresh", refreshes, 1));
    }

    private static List<Double> numbers(String option, String text, double most) {
        return OptionValues.split(text).stream()
                .map(n -> OptionValues.number(option, n, 1e-5, most))
                .toList();
    }

    private void write(ErrorTable measured, ErrorReport report) {
        Path csv = out.resolve("error.csv");
        measured.write(csv);
        AtomicFile.write(out.resolve("error.md"), MarkdownPage.format(report.document()));
        JsonWriter.write(out.resolve("error.json"), report.values());
        System.setProperty("java.awt.headless", "true");
        if (Annotations.hasFonts()) {
            ErrorChart.write(csv, "Speed against error", out.resolve("error.png"));
        } else {
            spec.commandLine().getErr().println("This Java has no fonts: no chart is drawn.");
        }
    }

    private void print(
            List<ErrorStudy> studies, ErrorTable measured, ErrorReport report, List<Scenario> scenarios, double most) {
        PrintWriter stdout = spec.commandLine().getOut();
        if (json) {
            stdout.print(JsonWriter.format(report.values()));
        } else {
            for (ErrorStudy study : studies) {
                stdout.println(ErrorReport.heading(study));
                stdout.println();
                stdout.print(text(study));
                study.equilibrium().forEach(q -> stdout.println(ErrorReport.lagSentence(study, q)));
                study.skipped().forEach(line -> stdout.println("not run: " + line));
                stdout.println();
            }
            report.meshSentences().forEach(stdout::println);
        }
        PrintWriter told = json ? spec.commandLine().getErr() : stdout;
        if (!Double.isNaN(most)) {
            scenarios.forEach(s -> told.println(measured.cheapest(s, most).sentence()));
        }
        if (!json) {
            stdout.println(CliNotice.TEXT);
        }
        stdout.flush();
        told.flush();
    }

    private static String text(ErrorStudy study) {
        boolean[] right = new boolean[ErrorReport.COLUMNS.size()];
        for (int i = 0; i < right.length; i++) {
            right[i] = ErrorReport.COLUMNS.get(i).number();
        }
        TextTable lines = new TextTable(right);
        lines.row(ErrorReport.COLUMNS.stream().map(c -> c.heading()).toArray(String[]::new));
        ErrorReport.cells(study).forEach(line -> lines.row(line.toArray(String[]::new)));
        return lines.text();
    }
}
