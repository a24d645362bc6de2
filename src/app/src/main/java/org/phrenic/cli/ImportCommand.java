package org.phrenic.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.NameRanges;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.FileNames;
import org.phrenic.file.Numbers;
import org.phrenic.patient.ImportProgress;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.diaphragm.SheetQuality;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.pipeline.ImportPipeline;
import org.phrenic.patient.pipeline.ImportRequest;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic import}: makes a thorax folder of a label volume or of a folder of meshes. */
@Command(
        name = "import",
        description = "Make a thorax folder of a segmented scan: a closed surface for each label.",
        footer = {
            "",
            "Examples:",
            "  phrenic import scan.seg.nrrd --out patient",
            "  phrenic import total.nii.gz --labels totalsegmentator --out patient",
            "  phrenic import segmentations --out patient",
            "  phrenic import lungs.mha --labels lungs.csv --out patient",
            "  phrenic import bones --complete virtual/adult-female --out patient",
            "  phrenic import inspiration.mha --labels lungs.csv --align-to patient --out inspired",
            "",
            "A table for --labels has the columns label (or name) and structure: 1,lungs.",
            Disclaimer.TEXT
        })
final class ImportCommand extends ReportingCommand {
    private static final double MAX_EDGE_MM = 50;
    /** Table headings by report key. */
    private static final Map<String, String> COLUMNS = new LinkedHashMap<>();

    static {
        COLUMNS.put("structure", "structure");
        COLUMNS.put("source", "from");
        COLUMNS.put("label_volume_ml", "label ml");
        COLUMNS.put("mesh_volume_ml", "mesh ml");
        COLUMNS.put("label_surface_vertices", "label nodes");
        COLUMNS.put("decimated_vertices", "decimated");
        COLUMNS.put("vertices", "vertices");
        COLUMNS.put("off_label_mean_mm", "off label mm");
        COLUMNS.put("off_label_mean_voxels", "in voxels");
        COLUMNS.put("off_label_maximum_mm", "max mm");
        COLUMNS.put("smallest_angle_deg", "angle deg");
        COLUMNS.put("edge_ratio", "edge ratio");
        COLUMNS.put("cut_at", "cut at");
    }

    @Parameters(
            paramLabel = "LABELS",
            description =
                    "A label volume (nii, nii.gz, nrrd, nhdr, mha, mhd, dcm), a folder of masks or a folder of meshes.")
    private Path file;

    @Option(
            names = "--labels",
            paramLabel = "MAP",
            description = "Which label is which structure: a CSV file, the name of a tool or data set such as "
                    + "totalsegmentator or vista3d, lungs (label 1 is both lungs), or names of labels as of nnU-Net "
                    + "(dataset.json), ITK-SNAP or 3D Slicer. Without it, the names in the volume or beside it, or "
                    + "the numbers that fit.")
    private String labels;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "The thorax folder to write.")
    private Path out;

    @Option(
            names = "--edge",
            paramLabel = "MM",
            description = "Edge of the triangles, 0 for those of the decimation. Default: 4 on soft organs, 2.5 on "
                    + "bones, 8 on skin and muscles, or a voxel.")
    private String edge;

    @Option(
            names = "--axes",
            paramLabel = "XYZ",
            description = "Sides of the body to which columns, rows and slices run, such as LPS, where the file "
                    + "states them wrongly.")
    private String axes;

    @Option(
            names = "--spacing",
            paramLabel = "X,Y,Z",
            description = "Size of a voxel along columns, rows and slices, mm, such as 1.75,1.75,1.25, where the file "
                    + "states it wrongly.")
    private String spacing;

    @Option(
            names = "--complete",
            paramLabel = "BODY",
            description = "Where structures come from that the scan lacks: virtual/adult-male (default), "
                    + "virtual/adult-female, a thorax folder, or none.")
    private String complete = RunSettings.VIRTUAL_MAN;

    @Option(
            names = "--keep-level",
            description = "Leave a scan at inspiration as it is, where it would be brought to end-expiration.")
    private boolean keepLevel;

    @Option(
            names = "--align-to",
            paramLabel = "THORAX",
            description = "A body made of another scan of the same patient: this scan is brought to it rigidly, by "
                    + "the spine or by apex and back of the lungs, and the distances of the lungs are "
                    + "told. Nothing is completed.")
    private Path alignTo;

    @Override
    public Integer call() {
        ReportFolder.requireWritable(out);
        if (alignTo != null) {
            requireRead(
                    name -> !name.equals("--complete") && !name.equals("--keep-level"),
                    "with --align-to, with which nothing is completed");
        } else if (complete.equals("none")) {
            requireRead(name -> !name.equals("--keep-level"), "with --complete none, which keeps every level");
        }
        ReportFolder.requireNotRead("--out", out, file, alignTo, Path.of(complete));
        Optional<Double> edgeMm =
                Optional.ofNullable(edge).map(text -> OptionValues.number("--edge", text, 0, MAX_EDGE_MM));
        ConsoleProgress progress = progress();
        ImportResult result = ImportPipeline.run(
                new ImportRequest(
                        file,
                        FileNames.ofBody(out),
                        Optional.ofNullable(labels),
                        edgeMm,
                        new GeometryOverride(Optional.ofNullable(axes), Optional.ofNullable(spacing)),
                        template(progress).map(thorax -> new ImportRequest.Completion(thorax, keepLevel)),
                        Optional.ofNullable(alignTo).map(ThoraxFolder::loadWholeOrPart)),
                progress);
        result.write(out);
        print(result.report(), () -> text(result));
        return ExitCode.SUCCESS;
    }

    private Optional<Thorax> template(ImportProgress progress) {
        if (alignTo != null || complete.equals("none")) {
            return Optional.empty();
        }
        progress.stage("loading " + complete + ", for what the scan lacks");
        Assignment anatomy = Assignment.read("--complete " + complete, "anatomy", complete);
        return Optional.of(SimulationRun.loadThorax(Scenario.defaults().with(List.of(anatomy))));
    }

    private static String text(ImportResult result) {
        PatientBody body = result.body();
        TextTable table = new TextTable(false, false, true, true, true, true, true, true, true, true, true, true, false)
                .row(COLUMNS.values().toArray(String[]::new));
        for (Object row : (List<?>) result.report().get("structures")) {
            table.row(COLUMNS.keySet().stream()
                    .map(key -> cell(key, ((Map<?, ?>) row).get(key)))
                    .toArray(String[]::new));
        }
        StringBuilder text = new StringBuilder();
        result.grid()
                .ifPresent(grid -> text.append(Numbers.format(
                        "%s: %d x %d x %d voxels of %.3g x %.3g x %.3g mm\n\n",
                        result.file(),
                        grid.columns(),
                        grid.rows(),
                        grid.slices(),
                        grid.spacing(0),
                        grid.spacing(1),
                        grid.spacing(2))));
        text.append(table.text());
        result.quality().ifPresent(quality -> text.append('\n').append(text(quality)));
        text.append("\nmissing: ")
                .append(body.missing().isEmpty() ? "nothing" : String.join(", ", NameRanges.collapse(body.missing())))
                .append(".\n");
        if (!body.canBreathe()) {
            text.append("This body cannot breathe: it takes a diaphragm and ribs.\n");
        }
        body.notes().forEach(note -> text.append(note).append(".\n"));
        return text.append('\n').append(Disclaimer.TEXT).append('\n').toString();
    }

    private static String text(SheetQuality quality) {
        TextTable table = new TextTable(Column.list("diaphragm | # value | # limit | unit | "));
        for (SheetQuality.Measure m : quality.measures()) {
            table.row(
                    m.what(),
                    Numbers.format("%.2f", m.value()),
                    Numbers.format("%.0f", m.limit()),
                    m.unit(),
                    m.isGood() ? "" : "beyond");
        }
        return table.text();
    }

    private static String cell(String key, Object value) {
        String format = key.endsWith("mm") || key.endsWith("voxels") ? "%.2f" : "%.1f";
        return value instanceof Double number ? Numbers.format(format, number) : value == null ? "-" : value.toString();
    }
}
