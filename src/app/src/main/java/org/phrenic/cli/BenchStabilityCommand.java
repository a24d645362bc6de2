package org.phrenic.cli;

import java.nio.file.Path;
import java.util.List;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.OutputFolder;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.stability.StabilityReport;
import org.phrenic.study.stability.StabilityStudy;
import picocli.CommandLine.Command;
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
            "  phrenic bench stability --out result                    the long version: about half an hour",
            "  phrenic bench stability --only published,sliders --integrator verlet,rk2",
            "",
            "DIR gets stability.md, stability.csv and stability.json. Exit code 3 if a cell fails in silence.",
            "The cases: docs/stability.md."
        })
final class BenchStabilityCommand extends ReportingCommand {
    private static final double MAX_SPEND = 1e15;

    @Option(names = "--quick", description = "Shorter times on coarser domes: a minute or two.")
    private boolean quick;

    @Option(names = "--only", paramLabel = "CASE,...", description = "Only these cases.")
    private String only;

    @Option(names = "--integrator", paramLabel = "NAME,...", description = "Only these integrators.")
    private String integrators;

    @Option(
            names = "--spend",
            paramLabel = "N",
            description = "Evaluations of the force on a node that a cell may spend before it ends early"
                    + " (default 5e8, for verlet 5e10; with --quick 2e7).")
    private String spend;

    @Option(names = "--threads", paramLabel = "N", description = "Cases at a time; the numbers do not depend on it.")
    private String threads;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path out;

    @Override
    public Integer call() {
        if (out != null) {
            OutputFolder.requireWritable(out);
        }
        StabilityStudy study = StabilityStudy.of(settings(), progress("cells done"));
        StabilityReport report = new StabilityReport(study);
        if (out != null) {
            AtomicFile.write(out.resolve("stability.md"), report.markdown());
            AtomicFile.write(out.resolve("stability.csv"), report.csv());
            JsonWriter.write(out.resolve("stability.json"), report.values());
        }
        print(report.values(), () -> table(report.table()) + "\n" + report.summary() + "\n");
        return study.passes() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private StabilityStudy.Settings settings() {
        StabilityStudy.Settings usual = quick ? StabilityStudy.Settings.QUICK : StabilityStudy.Settings.LONG;
        List<String> cases = only == null ? List.of() : OptionValues.split(only);
        for (String key : cases) {
            if (!StabilityStudy.caseKeys().contains(key)) {
                throw new BadInputException(
                        "--only: found '" + key + "', expected " + String.join(", ", StabilityStudy.caseKeys()));
            }
        }
        List<IntegratorKind> kinds = integrators == null
                ? usual.integrators()
                : OptionValues.split(integrators).stream()
                        .map(IntegratorKind::of)
                        .toList();
        StabilityStudy.Settings settings = usual.only(cases, kinds)
                .withThreads(
                        threads == null
                                ? Scenario.defaults().threads()
                                : OptionValues.integer("--threads", threads, 1, Numerics.MAX_THREADS));
        return spend == null ? settings : settings.withEvaluations(OptionValues.number("--spend", spend, 1, MAX_SPEND));
    }

    private static String table(List<List<String>> rows) {
        return new TextTable(new boolean[rows.get(0).size()]).rows(rows).text();
    }
}
