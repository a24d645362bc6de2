package org.phrenic.study.body;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.FileNames;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.mesh.io.VtpWriter;
import org.phrenic.mesh.io.raster.VolumeSource;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.io.volume.NiftiWriter;
import org.phrenic.patient.pipeline.ImportPipeline;
import org.phrenic.patient.pipeline.ImportRequest;
import org.phrenic.patient.pipeline.ImportResult;

/** Bodies that are imported from scans, real or simulated, by the way that {@code phrenic import} takes. */
public final class ImportedBodies {
    /** Follows the name of a body in that of the folder with the meshes that are its scan. */
    private static final String MESHES = "-meshes";

    private static final Pattern ENDING = Pattern.compile(
            "\\.(" + String.join("|", LabelVolumeFiles.READABLE).replace(".", "\\.") + ")$", Pattern.CASE_INSENSITIVE);

    private ImportedBodies() {}

    /** The folders that a scan and its body of a name may be written to. */
    public static List<Path> folders(Path folder, String name) {
        return List.of(folder.resolve(name), folder.resolve(name + MESHES));
    }

    /**
     * One body for each simulated scan of a body. The scan is written to {@code FOLDER/NAME.nii.gz} and the body to
     * {@code FOLDER/NAME}.
     *
     * @param template completes the bodies; loaded for each of them
     * @param folder receives scans and bodies
     */
    public static List<BodyCase> cuts(
            BodyCase source, Collection<BodyCut> cuts, Supplier<Thorax> template, Path folder) {
        InspiredBody inspired = new InspiredBody(source.thorax(), Resolution.LOW.budget(), shares(cuts));
        return cuts(source, cuts, inspired, template, folder, BodyCut.VOXEL_MM);
    }

    /** The shares of inspiration at which scans show a body. */
    static Set<Double> shares(Collection<BodyCut> cuts) {
        return cuts.stream()
                .map(BodyCut::inspiration)
                .filter(share -> share > 0)
                .collect(Collectors.toSet());
    }

    /**
     * As {@link #cuts(BodyCase, Collection, Supplier, Path)}.
     *
     * @param inspired inspiration of the body
     * @param voxelMm edge length of the voxels, mm
     */
    static List<BodyCase> cuts(
            BodyCase source,
            Collection<BodyCut> cuts,
            InspiredBody inspired,
            Supplier<Thorax> template,
            Path folder,
            double voxelMm) {
        String stem = stem(source.name());
        return cuts.stream()
                .map(cut -> {
                    String name = stem + "-" + cut.label();
                    return new BodyCase(
                            name,
                            stem + ", scanned: " + cut.description(),
                            source.height(),
                            () -> {
                                Thorax body = cut.inspiration() > 0
                                        ? inspired.at(cut.inspiration())
                                        : source.thorax().get();
                                return imported(scanned(name, body, cut, template.get(), folder, voxelMm), folder);
                            },
                            Optional.of(() -> CutScan.inScan(source.thorax().get(), cut)));
                })
                .toList();
    }

    /** Writes what a scan of a body shows and asks for its import. */
    static ImportRequest scanned(String name, Thorax body, BodyCut cut, Thorax template, Path folder, double voxelMm) {
        if (cut == BodyCut.BONE_MESHES) {
            Path meshes = folder.resolve(name + MESHES);
            deleteMeshes(meshes);
            body.structures().stream()
                    .filter(s -> cut.shows(s.kind()))
                    .forEach(s -> VtpWriter.write(meshes.resolve(s.name() + ".vtp"), s.mesh(), Map.of()));
            return ImportRequest.of(meshes, name, Optional.empty(), template);
        }
        Path file = folder.resolve(name + ".nii.gz");
        NiftiWriter.write(file, CutScan.of(body, cut, voxelMm));
        return ImportRequest.of(file, name, Optional.of(cut.numbers()), template);
    }

    /** Deletes those of an earlier scan, which may have shown other structures. */
    private static void deleteMeshes(Path folder) {
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path mesh : files.filter(MeshFiles::isMesh).toList()) {
                    Files.delete(mesh);
                }
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    /**
     * The body of a scan, named after its file or folder.
     *
     * @param file label volume or folder of meshes
     * @param template completes the body
     * @param folder receives the body as {@code FOLDER/NAME}
     */
    public static BodyCase scan(Path file, Supplier<Thorax> template, Path folder) {
        String name = scanName(file);
        return new BodyCase(
                name,
                "scan " + (Files.isDirectory(file) ? FileNames.ofBody(file) : file.getFileName()),
                1,
                () -> imported(ImportRequest.of(file, name, Optional.empty(), template.get()), folder));
    }

    private static String scanName(Path file) {
        if (Files.isDirectory(file)) {
            return FileNames.ofBody(file);
        }
        VolumeSource source = VolumeSource.of(file);
        String name =
                ENDING.matcher(String.valueOf(source.path().getFileName())).replaceFirst("");
        return source.phase().isPresent() ? name + "-" + source.phase().getAsInt() : name;
    }

    /** The last part of a body's name, which may be a path; of a folder its own name, though the path be a dot. */
    private static String stem(String body) {
        Path path = FileNames.path(body);
        return Files.isDirectory(path) ? FileNames.ofBody(path) : String.valueOf(path.getFileName());
    }

    private static Thorax imported(ImportRequest request, Path folder) {
        ImportResult result = ImportPipeline.run(request, (count, total, structure) -> {});
        result.write(folder.resolve(request.name()));
        return result.body().thorax();
    }
}
