package org.phrenic.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.PictureOptions;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.CompareReport;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.mesh.io.PlyWriter;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.scene.SurfacePictures;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.PngFile;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic compare}: computes the distance between two surfaces. */
@Command(
        name = "compare",
        description = "Say how far two surfaces lie apart, from the vertices of each to the other.",
        footer = {
            "",
            "Examples:",
            "  phrenic compare simulated.vtp scan.ply",
            "  phrenic compare before.stl after.stl --json --csv distances.csv",
            "  phrenic compare simulated.vtp scan.ply --ply coloured.ply --picture map.png --view superior "
                    + "--range 0:10",
            "",
            "Both files are taken to be in mm and in the same axes; nothing is aligned.",
            Disclaimer.TEXT
        })
final class CompareCommand extends ReportingCommand {
    @Parameters(index = "0", paramLabel = "A", description = "A mesh: stl, obj, ply, vtk, vtp.")
    private Path a;

    @Parameters(index = "1", paramLabel = "B", description = "The mesh to compare it with.")
    private Path b;

    @Option(names = "--csv", paramLabel = "FILE", description = "Distance of every vertex of A from B, as a table.")
    private Path csv;

    @Option(
            names = "--ply",
            paramLabel = "FILE",
            description = "A with the distance of each vertex from B as the property distance_mm.")
    private Path ply;

    @Option(names = "--picture", paramLabel = "FILE", description = "A in colours of its distance from B, as PNG.")
    private Path picture;

    @Option(names = "--range", paramLabel = "MIN:MAX", description = "Range of these colours, mm.")
    private String range;

    @Mixin
    private PictureOptions shotOptions;

    @Override
    public Integer call() throws NoGraphicsException {
        String title = name(a) + " from " + name(b);
        List<PictureSettings> shots = shotOptions.settings(title);
        if (picture == null) {
            requireRead(
                    name -> !name.equals("--range") && !PictureOptions.NAMES.contains(name),
                    "without --picture, expected both");
        }
        if (picture != null && !name(picture).toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw new BadInputException("--picture " + picture + ": found another ending, expected .png");
        }
        Path[] written = {csv, ply, picture};
        String[] options = {"--csv", "--ply", "--picture"};
        for (int i = 0; i < written.length; i++) {
            ReportFolder.requireWritableFile(options[i], written[i]);
            if (written[i] != null) {
                ReportFolder.requireNotRead(options[i], written[i], a, b);
                requireOwn(options[i], written[i], Arrays.copyOf(written, i));
            }
        }
        TriangleMesh from = MeshFiles.read(a);
        TriangleMesh to = MeshFiles.read(b);
        SurfaceComparison comparison = SurfaceComparison.of(from, to);
        ColourScale scale = scale(comparison);
        if (csv != null) {
            CsvWriter.write(csv, columns(from, to, comparison), CsvWriter.ALL_DIGITS);
        }
        if (ply != null) {
            PlyWriter.write(ply, from, Map.of("distance_mm", comparison.aToB().distances()));
        }
        CompareReport report = new CompareReport(a, b, comparison);
        try {
            print(report, picture == null ? List.of() : pictures(from, comparison, shots, scale));
        } catch (NoGraphicsException undrawn) {
            print(report, List.of());
            throw undrawn;
        }
        return ExitCode.SUCCESS;
    }

    private void print(CompareReport report, List<String> pictures) {
        print(report.values(pictures), () -> withDisclaimer(report.table()));
    }

    private static void requireOwn(String option, Path file, Path... others) {
        for (Path other : others) {
            if (other != null && FileNames.isSamePlace(file, other)) {
                throw new BadInputException(option + " " + file + ": found it for another output too, expected a file"
                        + " of its own for each");
            }
        }
    }

    private static String name(Path file) {
        return String.valueOf(file.getFileName());
    }

    private Map<String, double[]> columns(TriangleMesh from, TriangleMesh to, SurfaceComparison comparison) {
        IntFunction<double[]> axis = k -> IntStream.range(0, from.vertexCount())
                .mapToDouble(v -> from.positions()[3 * v + k])
                .toArray();
        Map<String, double[]> columns = new LinkedHashMap<>();
        columns.put("x_mm", axis.apply(0));
        columns.put("y_mm", axis.apply(1));
        columns.put("z_mm", axis.apply(2));
        columns.put("area_mm2", comparison.aToB().weights());
        columns.put("distance_mm", comparison.aToB().distances());
        if (comparison.corresponding().isPresent()) {
            columns.put("displacement_mm", SurfaceComparison.displacements(from, to));
        }
        return columns;
    }

    /** The given range, or a round range that contains 95 % of the surface; diverging for signed distances. */
    private ColourScale scale(SurfaceComparison comparison) {
        double round = ColourScale.roundRange(comparison.aToB().byArea().percentile95());
        String unit = ColourField.DISTANCE.unit();
        ColourScale usual =
                comparison.aToB().signed() ? ColourScale.diverging(round, unit) : ColourScale.sequential(round, unit);
        return range == null ? usual : OptionValues.range("--range", range, usual);
    }

    private List<String> pictures(
            TriangleMesh from, SurfaceComparison comparison, List<PictureSettings> shots, ColourScale scale)
            throws NoGraphicsException {
        List<String> made = new ArrayList<>();
        try (SurfacePictures drawn = new SurfacePictures()) {
            for (PictureSettings shot : shots) {
                String stem = name(picture).replaceFirst("(?i)(\\.png)?$", "");
                Path file = shots.size() == 1
                        ? picture
                        : picture.resolveSibling(stem + "_" + shot.view().label() + ".png");
                double[] distances = comparison.aToB().distances();
                PngFile.write(file, drawn.distances(from, distances, shot, scale, from.bounds()));
                made.add(file.toString());
            }
        }
        return made;
    }
}
