package org.phrenic.cli.bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.report.FailedWay;
import org.phrenic.study.sweep.report.StudyCost;
import org.phrenic.study.sweep.report.StudyCostReport;
import org.phrenic.study.sweep.run.ClusterService;
import org.phrenic.study.sweep.run.StudyMeasurement;
import org.phrenic.study.sweep.run.SweepExecutor;
import org.phrenic.study.sweep.run.ThreadExecutor;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic bench studies}: runs one study in several ways and compares costs and rows. */
@Command(
        name = "studies",
        description = "Measure what a study costs on one and more threads, in shards and on Apache Spark, and whether"
                + " all give the same rows.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench studies data/studies/load.yaml --threads 1,2 --shards 3 --out result",
            "  spark-submit phrenic-cluster.jar bench studies study.yaml --master 'local[2]' --out result",
            "",
            "DIR gets studies.md, studies.json and a folder for each way, which must not be there yet.",
            "Exit code 3 if rows differ or a way did not complete the study.",
            Disclaimer.TEXT
        })
final class BenchStudiesCommand extends ReportingCommand {
    private static final int MOST_SHARDS = 1000;

    @Parameters(paramLabel = "STUDY", description = "YAML file of the study.")
    private Path file;

    @Option(
            names = "--threads",
            paramLabel = "N,...",
            split = ",",
            description = "Runs at a time; without it one, and all processors.")
    private List<String> threads = new ArrayList<>();

    @Option(names = "--shards", paramLabel = "N", description = "Also N shards one after another, merged.")
    private String shards;

    @Option(
            names = "--master",
            paramLabel = "URL",
            description = "Also on this master of Apache Spark; may be repeated; needs phrenic-cluster.jar.")
    private List<String> masters = new ArrayList<>();

    @Option(names = "--out", required = true, paramLabel = "DIR", description = "Folder of the reports and the ways.")
    private Path out;

    @Mixin
    private ProvenanceOption provenance;

    @Override
    public Integer call() {
        ReportFolder.requireWritable(out);
        int processors = Runtime.getRuntime().availableProcessors();
        if (threads.isEmpty()) {
            threads = processors == 1 ? List.of("1") : List.of("1", String.valueOf(processors));
        }
        List<Integer> widths = threads.stream()
                .map(text -> OptionValues.threads(text, processors))
                .toList();
        int parts = shards == null ? 0 : OptionValues.integer("--shards", shards, 1, MOST_SHARDS);
        if (!masters.isEmpty()
                && ServiceLoader.load(ClusterService.class).findFirst().isEmpty()) {
            throw new BadInputException("--master: found no Apache Spark, expected this command in phrenic-cluster.jar"
                    + " (docs/cluster.md)");
        }
        requireNew(widths, parts);
        SweepStudy study = SweepStudy.read(file);
        StudyCostReport report = measure(study, widths, parts);
        AtomicFile.write(
                out.resolve("studies.md"), MarkdownPage.format(report.document(study.title(), provenance.lines())));
        JsonWriter.write(out.resolve("studies.json"), report.values());
        print(report.values(), () -> withDisclaimer(table(report)));
        return report.isEqual() && report.isComplete() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private StudyCostReport measure(SweepStudy study, List<Integer> widths, int parts) {
        List<StudyCost> costs = new ArrayList<>();
        List<FailedWay> failures = new ArrayList<>();
        try (ConsoleProgress progress = progress()) {
            for (int width : widths) {
                attempt(
                        costs,
                        failures,
                        threads(width),
                        () -> StudyMeasurement.measure(
                                threads(width),
                                folder(threads(width)),
                                SweepPlan.of(study),
                                new ThreadExecutor(width),
                                true,
                                progress));
            }
            if (parts > 0) {
                int width = widths.get(widths.size() - 1);
                attempt(
                        costs,
                        failures,
                        shards(parts),
                        () -> StudyMeasurement.ofShards(
                                shards(parts), folder(shards(parts)), SweepPlan.of(study), parts, width, progress));
            }
            for (String master : masters) {
                attempt(costs, failures, spark(master), () -> onSpark(master, study, progress));
            }
        }
        return new StudyCostReport(costs, failures);
    }

    private StudyCost onSpark(String master, SweepStudy study, ConsoleProgress progress) {
        ClusterService cluster =
                ServiceLoader.load(ClusterService.class).iterator().next();
        try (SweepExecutor executor = cluster.connect(master)) {
            boolean inProcess = master.equals("local") || master.startsWith("local[");
            return StudyMeasurement.measure(
                    spark(master), folder(spark(master)), SweepPlan.of(study), executor, inProcess, progress);
        }
    }

    /** A way that fails is reported; the ways after it are measured. */
    private static void attempt(
            List<StudyCost> costs, List<FailedWay> failures, String way, Supplier<StudyCost> measurement) {
        try {
            costs.add(measurement.get());
        } catch (BadInputException failure) {
            failures.add(new FailedWay(way, failure.getMessage()));
        }
    }

    private static String threads(int width) {
        return width == 1 ? "1 thread" : width + " threads";
    }

    private static String shards(int parts) {
        return parts + " shards, merged";
    }

    private static String spark(String master) {
        return "Spark " + master;
    }

    private Path folder(String way) {
        return out.resolve(way.replaceAll("[^A-Za-z0-9]+", "-"));
    }

    /** Refuses folders of an earlier run, and two ways with one folder: runs that are there cost nothing. */
    private void requireNew(List<Integer> widths, int parts) {
        Stream<String> ways = Stream.concat(
                widths.stream().map(BenchStudiesCommand::threads),
                Stream.concat(
                        parts > 0 ? Stream.of(shards(parts)) : Stream.of(),
                        masters.stream().map(BenchStudiesCommand::spark)));
        Set<Path> taken = new HashSet<>();
        ways.map(this::folder).forEach(folder -> {
            if (Files.exists(folder)) {
                throw new BadInputException(
                        "--out " + out + ": found " + folder + " of an earlier run, expected a folder without it");
            }
            if (!taken.add(folder)) {
                throw new BadInputException("found two ways that would be measured in " + folder
                        + ", of which the second would find the runs of the first, expected different ones");
            }
        });
    }

    private static String table(StudyCostReport report) {
        List<Column> columns = StudyCostReport.columns();
        List<List<String>> rows = new ArrayList<>();
        rows.add(columns.stream().map(Column::heading).toList());
        rows.addAll(report.rows());
        StringBuilder text = new StringBuilder(TextTable.ofNumbers(rows));
        report.failures().forEach(failure -> text.append("not completed: ")
                .append(failure.way())
                .append(". ")
                .append(failure.reason())
                .append(System.lineSeparator()));
        return text.toString();
    }
}
