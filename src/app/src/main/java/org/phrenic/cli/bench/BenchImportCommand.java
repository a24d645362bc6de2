package org.phrenic.cli.bench;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.BadInputException;
import org.phrenic.file.UnfinishedFiles;
import org.phrenic.study.scan.ImportCost;
import org.phrenic.study.scan.ImportCostReport;
import org.phrenic.study.scan.ScanSize;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic bench import}: time and memory of an import. */
@Command(
        name = "import",
        description = "Measure time and memory of importing a label volume, resampled to several sizes.",
        footer = {
            "",
            "Example:",
            "  phrenic bench import scan.nii.gz --size 311x311x431 --size 512x512x600 --out result",
            "",
            "DIR gets import.md and import.json. Other programs at work make the times longer.",
            Disclaimer.TEXT
        })
final class BenchImportCommand extends ReportingCommand {
    private static final String PROGRAM = "org.phrenic.cli.Phrenic";

    @Parameters(paramLabel = "SCAN", description = "Label volume with TotalSegmentator's numbers.")
    private Path scan;

    @Option(
            names = "--size",
            required = true,
            paramLabel = "CxRxS",
            description = "Number of columns, rows and slices; may be repeated.")
    private List<String> sizes = new ArrayList<>();

    @Option(
            names = "--heap",
            paramLabel = "SIZE",
            defaultValue = "2g",
            description = "Largest heap of the process that imports (${DEFAULT-VALUE}).")
    private String heap;

    @Mixin
    private ProvenanceOption provenance;

    @Mixin
    private ReportFolder out;

    @Override
    public Integer call() {
        out.check();
        List<ScanSize> wanted = sizes.stream().map(ScanSize::parse).toList();
        if (!heap.matches("[1-9]\\d{0,5}[mg]")) {
            throw new BadInputException("--heap: found '" + heap + "', expected a size such as 2g or 1500m");
        }
        ImportCost.Program program = new ImportCost.Program(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx" + heap,
                "-cp",
                classPath(),
                PROGRAM));
        List<ImportCost> costs = new ArrayList<>();
        try {
            for (ScanSize size : wanted) {
                costs.add(cost(size, program));
                ImportCostReport report = report(costs);
                out.write("import.md", MarkdownPage.format(report.document(provenance.lines())));
                out.write("import.json", report.values());
            }
        } finally {
            // A size that is not imported, such as for want of memory, leaves what was measured of the others.
            if (!costs.isEmpty()) {
                ImportCostReport measured = report(costs);
                print(measured.values(), () -> table(measured));
            }
        }
        return ExitCode.SUCCESS;
    }

    private ImportCostReport report(List<ImportCost> costs) {
        return new ImportCostReport(scan.getFileName().toString(), heap, costs);
    }

    /** The program's own class path, absolute. */
    private static String classPath() {
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator, -1))
                .map(entry -> Path.of(entry).toAbsolutePath().toString())
                .reduce((a, b) -> a + File.pathSeparator + b)
                .orElseThrow();
    }

    private ImportCost cost(ScanSize size, ImportCost.Program program) {
        try {
            Path folder = Files.createTempDirectory("phrenic-import");
            UnfinishedFiles.add(folder);
            try {
                return ImportCost.of(scan, size, program, folder);
            } finally {
                delete(folder);
                UnfinishedFiles.remove(folder);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }

    private static String table(ImportCostReport report) {
        TextTable table = new TextTable(Column.list(
                "voxels | # labels | # structures | # first_line_s | # clock_s | # processor_s | # memory_gb"));
        report.table().forEach(row -> table.row(row.toArray(String[]::new)));
        return withDisclaimer(table.text());
    }
}
