package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import org.phrenic.breathing.BreathingPreset;
import org.phrenic.format.AtomicFile;
import org.phrenic.format.BadInputException;
import org.phrenic.format.Json;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Scenario;
import org.phrenic.study.Finding;
import org.phrenic.study.LiverMotion;
import org.phrenic.study.PhysiologyTable;
import org.phrenic.study.Sensitivity;
import org.phrenic.study.SensitivityReport;
import org.phrenic.study.StudyProgress;
import org.phrenic.study.Validation;
import org.phrenic.study.ValidationReport;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code phrenic validate}: holds the model's breaths against what is known of people's. */
@Command(
        name = "validate",
        description = "Run the breathing presets and hold them against a table of physiology.",
        footer = {
            "",
            "Examples:",
            "  phrenic validate",
            "  phrenic validate --anatomy my-thorax --out result",
            "  phrenic validate --resolution low --preset quiet,deep --sensitivity",
            "  phrenic validate --liver --anatomy my-thorax",
            "",
            "DIR gets validation.md and validation.json, with --sensitivity also sensitivity.md and sensitivity.json; with --liver liver.json.",
            "Exit code 3 if a range of confidence S or R+ is missed. How each row is measured: docs/validation.md.",
            "",
            Notice.TEXT
        })
final class ValidateCommand implements Callable<Integer> {
    private static final String DEFAULT_BODY = "virtual/adult-male";
    /** What the command itself decides on. */
    private static final Set<String> RESERVED =
            Set.of("preset", "trace", "anatomy", "duration_s", "steps", "threads", "changes", "hold", "meshes_every_s");

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--anatomy",
            paramLabel = "BODY",
            description = "A body besides virtual/adult-male: a virtual one or a folder; may be repeated.")
    private List<String> anatomies = new ArrayList<>();

    @Option(names = "--resolution", paramLabel = "NAME", description = "low, medium or high (default medium).")
    private String resolution;

    @Option(names = "--preset", paramLabel = "NAME,...", description = "Only the rows of these presets.")
    private String presets;

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Any key of a scenario; may be repeated.")
    private List<String> settings = new ArrayList<>();

    @Option(names = "--table", paramLabel = "FILE", description = "Another table than data/validation/physiology.yaml.")
    private Path tableFile;

    @Option(
            names = "--sensitivity",
            description = "Also: which parameter moves which observable (low resolution, quiet).")
    private boolean sensitivity;

    @Option(
            names = "--liver",
            description = "Instead: how far the liver moves in quiet, deep and held breaths, beside what is known.")
    private boolean liver;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path out;

    @Option(names = "--threads", paramLabel = "N", description = "Runs at a time; the numbers do not depend on it.")
    private String threads;

    @Option(names = "--json", description = "Print JSON instead of a table.")
    private boolean json;

    @Override
    public Integer call() {
        if (out != null) {
            OutputFolder.require(out);
        }
        PhysiologyTable table = tableFile == null ? PhysiologyTable.shipped() : PhysiologyTable.read(tableFile);
        Scenario scenario = scenario();
        int atATime = threads == null
                ? scenario.threads()
                : OptionNumbers.whole("--threads", threads, 1, Scenario.MOST_THREADS);
        StudyProgress progress = new LineProgress(spec.commandLine().getErr());
        if (liver) {
            return liver(LiverMotion.of(table, scenario, bodies(), atATime, progress));
        }
        Validation validation = Validation.of(table, scenario, bodies(), only(), atATime, progress);
        ValidationReport report = new ValidationReport(validation);
        SensitivityReport effects = sensitivity
                ? new SensitivityReport(Sensitivity.of(scenario.with("resolution=low"), atATime, progress))
                : null;
        if (out != null) {
            AtomicFile.write(out.resolve("validation.md"), report.markdown());
            Json.write(out.resolve("validation.json"), report.values());
            if (effects != null) {
                AtomicFile.write(out.resolve("sensitivity.md"), effects.markdown());
                Json.write(out.resolve("sensitivity.json"), effects.values());
            }
        }
        print(validation, report, effects);
        return validation.passes() ? ExitCode.DONE : ExitCode.OUT_OF_RANGE;
    }

    private int liver(LiverMotion motion) {
        if (out != null) {
            Json.write(out.resolve("liver.json"), motion.values());
        }
        PrintWriter stdout = spec.commandLine().getOut();
        stdout.print(json ? Json.format(motion.values()) : table(motion.table()) + "\n" + Notice.TEXT + "\n");
        stdout.flush();
        return motion.outside() == 0 ? ExitCode.DONE : ExitCode.OUT_OF_RANGE;
    }

    private Scenario scenario() {
        List<Assignment> list = new ArrayList<>();
        if (resolution != null) {
            list.add(new Assignment("--resolution " + resolution, "resolution", resolution));
        }
        for (String text : settings) {
            Assignment assignment = Assignment.parse(text);
            if (RESERVED.contains(assignment.key())) {
                throw new BadInputException(
                        assignment.origin() + ": found a key that a validation sets itself, expected any other key");
            }
            list.add(assignment);
        }
        return Scenario.defaults().with(list);
    }

    private List<String> bodies() {
        Set<String> bodies = new LinkedHashSet<>(List.of(DEFAULT_BODY));
        bodies.addAll(anatomies);
        return List.copyOf(bodies);
    }

    private List<String> only() {
        if (presets == null) {
            return List.of();
        }
        List<String> only = OptionNumbers.parts(presets);
        for (String preset : only) {
            if (!BreathingPreset.names().contains(preset)) {
                throw new BadInputException(
                        "--preset: found '" + preset + "', expected " + String.join(", ", BreathingPreset.names()));
            }
        }
        return only;
    }

    private void print(Validation validation, ValidationReport report, SensitivityReport effects) {
        PrintWriter stdout = spec.commandLine().getOut();
        if (json) {
            Map<String, Object> values = new LinkedHashMap<>(report.values());
            if (effects != null) {
                values.put("sensitivity", effects.values());
            }
            stdout.print(Json.format(values));
        } else {
            validation.bodies().forEach(body -> stdout.print(table(body)));
            if (effects != null) {
                stdout.print(table(effects.cells()) + "\n");
            }
            stdout.print((validation.passes() ? "passed" : "failed: a range of confidence S or R+ is missed") + "\n"
                    + Notice.TEXT + "\n");
        }
        stdout.flush();
    }

    private static String table(Validation.Body body) {
        Table table = new Table(false, false, true, true, false, false, false)
                .row("quantity", "preset", "value", "range", "unit", "confidence", "verdict");
        for (Finding f : body.findings()) {
            boolean none = f.verdict() == Finding.Verdict.NOT_MEASURABLE;
            table.row(
                    f.row().key(),
                    f.row().preset().orElse("-"),
                    none ? "-" : ValidationReport.number(f.value()),
                    ValidationReport.range(f.row()),
                    f.row().unit(),
                    f.row().confidence().tag(),
                    (f.isMiss() ? "OUT" : f.verdict().label()) + (f.reason().isEmpty() ? "" : ": " + f.reason()));
        }
        return table.text() + ValidationReport.sum(body) + "\n\n";
    }

    private static String table(List<List<String>> cells) {
        boolean[] right = new boolean[cells.get(0).size()];
        Arrays.fill(right, 1, right.length, true);
        Table table = new Table(right);
        cells.forEach(line -> table.row(line.toArray(String[]::new)));
        return table.text();
    }
}
