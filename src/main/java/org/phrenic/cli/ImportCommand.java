package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.format.BadInputException;
import org.phrenic.format.Json;
import org.phrenic.format.LabelVolume;
import org.phrenic.format.LabelVolumes;
import org.phrenic.geometry.LabelGrid;
import org.phrenic.patient.BodyCompletion;
import org.phrenic.patient.BodyFolder;
import org.phrenic.patient.FittedBody;
import org.phrenic.patient.ImportProgress;
import org.phrenic.patient.ImportReport;
import org.phrenic.patient.LabelMap;
import org.phrenic.patient.MeshingSteps;
import org.phrenic.patient.ScanImport;
import org.phrenic.patient.SecondScan;
import org.phrenic.patient.StatedAxes;
import org.phrenic.patient.StatedSpacing;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SimulationRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code phrenic import}: a volume of labels becomes a thorax folder. */
@Command(
        name = "import",
        description = "Make a thorax folder of a segmented scan: a closed surface for each label.",
        footer = {
            "",
            "Examples:",
            "  phrenic import scan.seg.nrrd --out patient",
            "  phrenic import total.nii.gz --labels totalsegmentator --out patient",
            "  phrenic import lungs.mha --labels lungs.csv --out patient",
            "  phrenic import inspiration.mha --labels lungs.csv --align-to patient --out inspired",
            "",
            "A table for --labels has the columns label (or name) and structure: 1,lungs.",
            Notice.TEXT
        })
final class ImportCommand implements Callable<Integer> {
    private static final double LONGEST_EDGE_MM = 50;

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "LABELS", description = "A label volume: nii, nii.gz, nrrd, nhdr, mha, mhd.")
    private Path file;

    @Option(
            names = "--labels",
            paramLabel = "MAP",
            description =
                    "Which label is which structure: a CSV file, or totalsegmentator. Without it, the volume's own names.")
    private String labels;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "The thorax folder to write.")
    private Path out;

    @Option(
            names = "--edge",
            paramLabel = "MM",
            description =
                    "Edge of the triangles, 0 for those of the decimation. Default: 4 on soft organs, 2.5 on bones, 8 on skin, or a voxel.")
    private String edge;

    @Option(
            names = "--axes",
            paramLabel = "XYZ",
            description =
                    "Sides of the body to which columns, rows and slices run, such as LPS, where the file states them wrongly.")
    private String axes;

    @Option(
            names = "--spacing",
            paramLabel = "X,Y,Z",
            description =
                    "Size of a voxel along columns, rows and slices, mm, such as 1.75,1.75,1.25, where the file states it wrongly.")
    private String spacing;

    @Option(
            names = "--complete",
            paramLabel = "BODY",
            description =
                    "Where structures come from that the scan lacks: virtual/adult-male (default), virtual/adult-female, a thorax folder, or none.")
    private String complete = "virtual/adult-male";

    @Option(
            names = "--align-to",
            paramLabel = "THORAX",
            description =
                    "A body made of another scan of the same patient: this scan is brought to it rigidly, by the spine or by apex and back of the lungs, and the distances of the lungs are told. Nothing is completed.")
    private Path alignTo;

    @Option(names = "--json", description = "Print JSON instead of a table.")
    private boolean json;

    @Override
    public Integer call() {
        OutputFolder.require(out);
        Optional<Double> edgeMm =
                Optional.ofNullable(edge).map(text -> OptionNumbers.number("--edge", text, 0, LONGEST_EDGE_MM));
        ImportProgress progress = new Lines(spec.commandLine().getErr());
        LabelVolume read = LabelVolumes.read(file);
        LabelVolume turned = axes == null ? read : StatedAxes.apply(read, axes);
        LabelVolume volume = spacing == null ? turned : StatedSpacing.apply(turned, spacing);
        LabelMap map = map(volume);
        String name = out.toAbsolutePath().normalize().getFileName().toString();
        Optional<Thorax> template = template();
        FittedBody scanned =
                new ScanImport(volume, file.toString(), MeshingSteps.PAPER, edgeMm, progress).run(map, name);
        FittedBody body = alignTo == null
                ? template.map(t -> completed(scanned, t, progress)).orElse(scanned)
                : aligned(scanned, ThoraxFolder.load(alignTo));
        Map<String, Object> report = new LinkedHashMap<>(ImportReport.of(file.toString(), volume.grid(), body));
        report.put("notice", Notice.TEXT);
        BodyFolder.write(out, body, report);
        PrintWriter stdout = spec.commandLine().getOut();
        stdout.print(json ? Json.format(report) : text(volume.grid(), body));
        stdout.flush();
        return ExitCode.DONE;
    }

    private static FittedBody completed(FittedBody scanned, Thorax template, ImportProgress progress) {
        progress.now("bringing " + template.name() + " to the scan for what it lacks");
        return BodyCompletion.complete(scanned, template);
    }

    private FittedBody aligned(FittedBody scanned, Thorax first) {
        try {
            return SecondScan.alignedTo(first, scanned);
        } catch (IllegalArgumentException e) {
            throw new BadInputException(file + " and " + alignTo + ": " + e.getMessage(), e);
        }
    }

    private Optional<Thorax> template() {
        if (alignTo != null || complete.equals("none")) {
            return Optional.empty();
        }
        Assignment anatomy = new Assignment("--complete " + complete, "anatomy", complete);
        return Optional.of(SimulationRun.thorax(Scenario.defaults().with(List.of(anatomy))));
    }

    private LabelMap map(LabelVolume volume) {
        if (labels == null) {
            return LabelMap.named(file.toString(), volume);
        }
        return labels.equals(LabelMap.TOTALSEGMENTATOR)
                ? LabelMap.totalSegmentator(volume)
                : LabelMap.read(Path.of(labels), volume);
    }

    /** A line a stage. */
    private record Lines(PrintWriter err) implements ImportProgress {
        @Override
        public void done(int count, int total, String structure) {
            now(count + " of " + total + " structures meshed: " + structure);
        }

        @Override
        public void now(String what) {
            err.println(what);
            err.flush();
        }
    }

    private String text(LabelGrid grid, FittedBody body) {
        Table table = new Table(false, false, true, true, true, true, true, true, true, true, true, true, false)
                .row(
                        "structure",
                        "from",
                        "label ml",
                        "mesh ml",
                        "label nodes",
                        "decimated",
                        "vertices",
                        "off label mm",
                        "in voxels",
                        "max mm",
                        "angle deg",
                        "edge ratio",
                        "cut at");
        Map<String, Object> report = ImportReport.of(file.toString(), grid, body);
        for (Object row : (List<?>) report.get("structures")) {
            table.row(cells((Map<?, ?>) row));
        }
        StringBuilder text = new StringBuilder();
        text.append(String.format(
                Locale.ROOT,
                "%s: %d x %d x %d voxels of %.3g x %.3g x %.3g mm%n%n",
                file,
                grid.columns(),
                grid.rows(),
                grid.slices(),
                grid.spacing(0),
                grid.spacing(1),
                grid.spacing(2)));
        text.append(table.text());
        text.append("\nmissing: ")
                .append(body.missing().isEmpty() ? "nothing" : String.join(", ", Ranges.of(body.missing())))
                .append(".\n");
        if (!body.canBreathe()) {
            text.append("This body cannot breathe: it takes a diaphragm and ribs.\n");
        }
        body.notes().forEach(note -> text.append(note).append(".\n"));
        return text.append('\n').append(Notice.TEXT).append('\n').toString();
    }

    private static String[] cells(Map<?, ?> row) {
        List<String> cells = new ArrayList<>();
        for (String key : List.of(
                "structure",
                "source",
                "label_volume_ml",
                "mesh_volume_ml",
                "label_surface_vertices",
                "decimated_vertices",
                "vertices",
                "off_label_mean_mm",
                "off_label_mean_voxels",
                "off_label_maximum_mm",
                "smallest_angle_deg",
                "edge_ratio",
                "cut_at")) {
            Object value = row.get(key);
            cells.add(
                    value instanceof Double number
                            ? String.format(
                                    Locale.ROOT, key.endsWith("mm") || key.endsWith("voxels") ? "%.2f" : "%.1f", number)
                            : value == null ? "-" : value.toString());
        }
        return cells.toArray(String[]::new);
    }
}
