package org.phrenic.fit;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * Rigid motion that brought the scan of the targets to the axes of the body: a shift or turn of the patient between two
 * scans, which is no part of the breath.
 *
 * @param motion from the axes of the scan to those of the body
 * @param sentence how the motion was found
 */
public record TargetAlignment(RigidMotion motion, String sentence) {
    /** No motion: the targets are taken to be in the axes of the body. */
    public static final TargetAlignment NONE =
            new TargetAlignment(RigidMotion.identity(), "none: the targets are taken to be in the axes of the body");

    private static final String REPORT = "import.json";

    /**
     * Reads the alignment that an import wrote beside its meshes. Without one, the targets are taken to be in the axes
     * of the body.
     *
     * @throws BadInputException if the folders of the targets state different alignments
     */
    public static TargetAlignment beside(Collection<Path> targets) {
        List<TargetAlignment> all = targets.stream()
                .map(file -> file.toAbsolutePath().resolveSibling(REPORT))
                .distinct()
                .map(TargetAlignment::read)
                .toList();
        if (all.stream().map(TargetAlignment::sentence).distinct().count() > 1) {
            throw new BadInputException("--target: found meshes of scans that were aligned in different ways, expected"
                    + " those of one import");
        }
        return all.isEmpty() ? NONE : all.get(0);
    }

    private static TargetAlignment read(Path report) {
        if (!Files.isRegularFile(report)) {
            return NONE;
        }
        YamlMap map = YamlDocument.read(report).mapOrEmpty("alignment");
        if (!map.has("rotation")) {
            return NONE;
        }
        RigidMotion motion = RigidMotion.of(map.numbers("rotation"), map.numbers("translation_mm"));
        return new TargetAlignment(
                motion,
                Numbers.format(
                        "by %s, turned by %.2f deg; the nearer 70 %% of its points then lie %.2f mm apart (rms)",
                        map.text("fixed_part"), map.number("turn_deg"), map.number("inlier_residual_rms_mm")));
    }
}
