package org.phrenic.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.Sensitivity;
import org.phrenic.study.SensitivityReport;
import org.phrenic.study.validation.Finding;
import org.phrenic.study.validation.LiverMotion;
import org.phrenic.study.validation.PhysiologyTable;
import org.phrenic.study.validation.Validation;
import org.phrenic.study.validation.ValidationReport;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic validate}: compares simulated breaths with a table of physiological ranges. */
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
            "DIR gets validation.md and validation.json, with --sensitivity also sensitivity.md and "
                    + "sensitivity.json; with --liver liver.md and liver.json.",
            "Exit code 3 if a range of confidence S or R+ is missed. How each row is measured: docs/validation.md.",
            "",
            Disclaimer.TEXT
        })
final class ValidateCommand extends ReportingCommand {
    /** Scenario keys that the command sets. */
    private static final Set<String> RESERVED =
            Set.of("preset", "trace", "anatomy", "duration_s", "steps", "threads", "changes", "hold", "meshes_every_s");

    private static final Set<String> UNREAD_WITH_LIVER = Set.of("--preset", "--sensitivity");

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

    @Mixin
    private ProvenanceOption made;

    @Mixin
    private ReportFolder out;

    @Option(names = "--threads", paramLabel = "N", description = "Runs at a time; the numbers do not depend on it.")
    private String threads;

    @Override
    public Integer call() {
        out.check();
        if (liver) {
            requireRead(name -> !UNREAD_WITH_LIVER.contains(name), "with --liver, which does not read it");
        }
        PhysiologyTable table = tableFile == null ? PhysiologyTable.shipped() : PhysiologyTable.read(tableFile);
        Scenario scenario = scenario();
        int atATime = OptionValues.threads(threads, scenario.threads());
        ProgressListener progress = progress();
        if (liver) {
            return liver(LiverMotion.of(table, scenario, bodies(), atATime, progress), scenario);
        }
        List<String> only = OptionValues.names("--preset", presets, BreathingPreset.names());
        Validation validation = Validation.of(table, scenario, bodies(), only, atATime, progress);
        ValidationReport report = new ValidationReport(validation);
        SensitivityReport effects = sensitivity
                ? new SensitivityReport(Sensitivity.of(scenario.with("resolution=low"), atATime, progress))
                : null;
        List<String> provenance = made.lines();
        out.write("validation.md", MarkdownPage.format(report.document(provenance)));
        out.write("validation.json", report.values());
        if (effects != null) {
            out.write("sensitivity.md", MarkdownPage.format(effects.document(provenance)));
            out.write("sensitivity.json", effects.values());
        }
        print(validation, report, effects);
        boolean passes = validation.passes() && (effects == null || effects.isComplete());
        return passes ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    /** Reports the motion of the liver and returns the exit code. */
    int liver(LiverMotion motion, Scenario scenario) {
        out.write("liver.md", MarkdownPage.format(motion.document(scenario, made.lines())));
        out.write("liver.json", motion.values());
        print(motion.values(), () -> withDisclaimer(TextTable.ofNumbers(motion.table())));
        return motion.passes() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private Scenario scenario() {
        List<Assignment> list = new ArrayList<>();
        OptionValues.assign(list, "--resolution", "resolution", resolution);
        list.addAll(OptionValues.assignments(settings, RESERVED, "a validation"));
        return Scenario.defaults().with(list);
    }

    private List<String> bodies() {
        return Stream.concat(Stream.of(RunSettings.VIRTUAL_MAN), anatomies.stream())
                .distinct()
                .toList();
    }

    private void print(Validation validation, ValidationReport report, SensitivityReport effects) {
        Map<String, Object> values = new LinkedHashMap<>(report.values());
        if (effects != null) {
            values.put("sensitivity", effects.values());
        }
        print(values, () -> {
            StringBuilder text = new StringBuilder();
            validation.bodies().forEach(body -> text.append(table(body)));
            if (effects != null) {
                text.append(TextTable.ofNumbers(effects.cells())).append('\n');
            }
            text.append(verdict(validation, effects));
            return withDisclaimer(text.toString());
        });
    }

    private static String verdict(Validation validation, SensitivityReport effects) {
        int failed = validation.failures().size();
        if (!validation.passes()) {
            String breaths = failed == 1 ? "1 breath" : failed + " breaths";
            return "failed: " + (failed > 0 ? breaths : "a range of confidence S or R+ is missed");
        }
        return effects == null || effects.isComplete() ? "passed" : "failed: breaths of the sensitivity";
    }

    private static String table(Validation.Body body) {
        TextTable table =
                new TextTable(Column.list("quantity | preset | # value | # range | unit | confidence | verdict"));
        for (Finding f : body.findings()) {
            boolean none = f.verdict() == Finding.Verdict.NOT_MEASURABLE;
            table.row(
                    f.range().key(),
                    f.range().preset().orElse("-"),
                    none ? "-" : ReportNumbers.number(f.value()),
                    ValidationReport.range(f.range()),
                    f.range().unit(),
                    f.range().confidence().tag(),
                    (f.isMiss() ? "OUT" : f.verdict().label()) + (f.reason().isEmpty() ? "" : ": " + f.reason()));
        }
        return table.text() + ValidationReport.summary(body) + "\n\n";
    }
}
