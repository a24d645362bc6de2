package org.phrenic.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.SparkSubmit;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.BadInputException;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.report.SummaryPage;
import org.phrenic.study.sweep.report.SweepReport;
import org.phrenic.study.sweep.run.ClusterService;
import org.phrenic.study.sweep.run.Shard;
import org.phrenic.study.sweep.run.SweepExecutor;
import org.phrenic.study.sweep.run.SweepFolder;
import org.phrenic.study.sweep.run.SweepRunner;
import org.phrenic.study.sweep.run.ThreadExecutor;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;

/** {@code phrenic sweep}: many runs of one study. */
@Command(
        name = "sweep",
        description =
                "Run a study: many breaths with varied parameters and bodies, and what their responses depend on.",
        footer = {
            "",
            "Examples:",
            "  phrenic sweep study.yaml --out study",
            "  phrenic sweep study.yaml --out study               again after a kill: goes on where it ended",
            "  phrenic sweep study.yaml --out study --shard 0/3   a third of the runs, for any scheduler",
            "  phrenic sweep --merge study                        results of all shards in the folder",
            "  phrenic sweep study.yaml --out study --master 'local[2]'   on Apache Spark (docs/cluster.md)",
            "",
            "DIR gets runs.csv, study.json, report.html, with recorded series also series.csv; study.yaml and"
                    + " journal.csv let a study resume. The study file: docs/sweep.md.",
            Disclaimer.TEXT
        })
final class SweepCommand extends ReportingCommand {
    @Parameters(arity = "0..1", paramLabel = "STUDY", description = "YAML file of the study.")
    private Path file;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder of the study; resumes if it has begun.")
    private Path out;

    @Option(names = "--threads", paramLabel = "N", description = "Runs at a time (default: all processors).")
    private String threads;

    @Option(
            names = "--shard",
            paramLabel = "K/N",
            description = "Only shard K of N, counted from 0; writes its journal.")
    private String shard;

    @Option(names = "--merge", paramLabel = "DIR", description = "Write the results of all journals in the folder.")
    private Path merge;

    @Option(names = "--master", paramLabel = "URL", description = "Master of an Apache Spark cluster.")
    private String master;

    @Option(names = "--page", paramLabel = "FILE", description = "Also a Markdown page of the results, with pictures.")
    private Path page;

    @Mixin
    private ProvenanceOption provenance;

    @Override
    public Integer call() {
        if (page != null && shard != null) {
            throw new ParameterException(commandLine(), "found --page with --shard, expected --page with --merge");
        }
        if (page == null) {
            requireRead(name -> !name.equals("--made-by"), "without --page, expected both");
        }
        if (page != null && !page.toString().endsWith(".md")) {
            throw new BadInputException("--page: found '" + page + "', expected a Markdown file such as study.md");
        }
        ReportFolder.requireWritableFile("--page", page);
        ReportFolder.requireNotRead("--page", page, file);
        if (merge != null) {
            if (file != null || out != null || shard != null || master != null || threads != null) {
                throw new ParameterException(commandLine(), "found --merge with other options, expected it alone");
            }
            return merge();
        }
        if (file == null || out == null) {
            throw new ParameterException(
                    commandLine(),
                    "found no " + (file == null ? "study file" : "--out") + ", expected STUDY and --out");
        }
        if (shard != null && master != null) {
            throw new ParameterException(commandLine(), "found --shard with --master, expected one of them");
        }
        if (threads != null && master != null) {
            throw new ParameterException(commandLine(), "found --threads with --master, expected one of them");
        }
        ReportFolder.requireWritable(out);
        Shard part = shard == null ? Shard.WHOLE : Shard.parse(shard);
        SweepPlan plan = SweepPlan.of(SweepStudy.read(file));
        int width = OptionValues.threads(threads, Runtime.getRuntime().availableProcessors());
        if (master != null) {
            Optional<ClusterService> cluster =
                    ServiceLoader.load(ClusterService.class).findFirst();
            if (cluster.isEmpty()) {
                return SparkSubmit.run(master, argumentsWithoutMaster());
            }
            return run(plan, part, cluster.get().connect(master));
        }
        return run(plan, part, new ThreadExecutor(width));
    }

    /** What {@code spark-submit} hands on to the driver. */
    List<String> argumentsWithoutMaster() {
        List<String> arguments = new ArrayList<>(List.of("sweep", file.toString(), "--out", out.toString()));
        if (page != null) {
            arguments.addAll(List.of("--page", page.toString()));
        }
        arguments.addAll(provenance.arguments());
        for (OptionSpec given : commandLine().getParseResult().matchedOptions()) {
            if (given.longestName().equals("--json") || given.longestName().equals("--debug")) {
                arguments.add(given.longestName());
            }
        }
        return arguments;
    }

    private int run(SweepPlan plan, Shard part, SweepExecutor executor) {
        try (executor) {
            return report(SweepRunner.run(SweepFolder.of(out, plan), part, executor, progress()), part);
        }
    }

    private int merge() {
        SweepResults results = SweepFolder.existing(merge).merge();
        results.builds().ifPresent(builds -> err().println("phrenic: " + builds));
        return report(results, Shard.WHOLE);
    }

    private int report(SweepResults results, Shard part) {
        SweepReport report = new SweepReport(results, 0, 1);
        if (page != null) {
            new SummaryPage(page, report.summary(provenance.lines("--out", "--merge"))).write();
        }
        print(report.values(), () -> {
            String state = results.done() + " of " + results.plan().size() + " runs are done, " + results.failed()
                    + " failed; " + ReportNumbers.number(results.wallS()) + " s of computing time\n";
            List<List<String>> rows = new ArrayList<>(List.of(report.sensitivityHeadings()));
            rows.addAll(report.sensitivity());
            return withDisclaimer((part.count() == 1 ? TextTable.ofNumbers(rows) + "\n" : "") + state);
        });
        boolean missing = part.count() == 1 && !results.isComplete();
        if (missing) {
            err().println("phrenic: " + (results.plan().size() - results.done()) + " runs are missing");
        }
        List<RunRow> own = results.rows().stream()
                .filter(row -> part.contains(row.index()))
                .toList();
        boolean allFailed = !own.isEmpty() && own.stream().allMatch(RunRow::isFailed);
        return missing || allFailed ? ExitCode.FAILURE : ExitCode.SUCCESS;
    }
}
