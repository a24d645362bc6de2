package org.phrenic.patient;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * Fragments under the names of whole structures, such as a speck with the label of the first rib in a scan of the
 * abdomen, or gas of the bowel with that of a lung. No end of the scan cuts them, so that a template would be deformed
 * until its structure is as small and lies there. Volumes, and lengths of ribs, are compared with those of a template.
 */
public final class ScanFragments {
    /**
     * Least volume of a structure over the template's in a body of the template's size. Of five scans the smallest
     * structure that is whole, a twelfth rib, has a third; collapsed lungs and vertebrae without processes have less.
     */
    private static final Map<StructureKind, Double> LEAST_SHARES = new EnumMap<>(Map.of(
            StructureKind.RIB, 0.03,
            StructureKind.VERTEBRA, 0.1,
            StructureKind.LUNG, 0.03,
            StructureKind.LIVER, 0.03));

    /**
     * Least length of a rib over the template's, in a body of its size: coarse voxels make a speck that is large beside
     * a thin rib.
     */
    private static final double LEAST_LENGTH = 0.25;
    /** The same of the ribs that may be short from birth. */
    private static final double LEAST_LENGTH_FLOATING = 0.1;

    private static final int FIRST_FLOATING = 11;

    /** Share of the structures that are smaller, over the template's, than the one that tells the size of the body. */
    private static final double QUANTILE = 0.75;
    /** Least number of whole structures that tell the size of the body. */
    private static final int ENOUGH = 4;

    private ScanFragments() {}

    /** Returns the body without fragments, with a note that names them. */
    public static PatientBody leftOut(PatientBody body, Thorax template) {
        List<Ratio> ratios = ratios(body, template);
        if (ratios.isEmpty()) {
            return body;
        }
        double size = size(ratios);
        List<Ratio> fragments =
                ratios.stream().filter(r -> r.complete && r.isFragment(size)).toList();
        if (fragments.isEmpty()) {
            return body;
        }
        List<PatientStructure> rest = body.structures().stream()
                .filter(s -> fragments.stream().noneMatch(fragment -> fragment.structure.isSameAs(s.structure())))
                .toList();
        List<String> names = fragments.stream()
                .map(r -> Numbers.format("%s (%.2g ml)", r.structure.name(), r.ml))
                .toList();
        return new PatientBody(body.name(), rest, ExpectedStructures.missing(rest), body.notes())
                .withNotes(List.of("left out, too small for what their labels name though the scan does not cut them: "
                        + String.join(", ", names)));
    }

    /**
     * Volume of a body over that of a template, by the bones, lungs and liver that the scan shows as a whole: 1 at
     * most, and 1 where it shows few.
     */
    public static double size(PatientBody body, Thorax template) {
        List<Ratio> whole =
                ratios(body, template).stream().filter(Ratio::complete).toList();
        return whole.size() < ENOUGH ? 1 : size(whole);
    }

    private static double size(List<Ratio> ratios) {
        double[] sorted =
                ratios.stream().mapToDouble(Ratio::toTemplate).sorted().toArray();
        return Math.min(1, sorted[Math.min(sorted.length - 1, (int) (QUANTILE * sorted.length))]);
    }

    /** Compares each structure of the scan with that of the template. */
    private static List<Ratio> ratios(PatientBody body, Thorax template) {
        List<Ratio> ratios = new ArrayList<>();
        for (PatientStructure s : body.structures()) {
            boolean seen = ratios.stream().anyMatch(other -> other.structure.isSameAs(s.structure()));
            if (!seen
                    && s.scan().isPresent()
                    && LEAST_SHARES.containsKey(s.structure().kind())) {
                ratio(body, s.structure(), template).ifPresent(ratios::add);
            }
        }
        return ratios;
    }

    /** Compares all parts of a structure with those of the template. */
    private static Optional<Ratio> ratio(PatientBody body, Structure like, Thorax template) {
        List<PatientStructure> parts = body.structures().stream()
                .filter(s -> s.structure().isSameAs(like))
                .toList();
        return PatientBody.merged(template.structures(), like)
                .filter(mesh -> MeshMeasure.signedVolumeMl(mesh) > 0)
                .map(mesh -> {
                    TriangleMesh shown = PatientBody.merged(parts.stream().map(PatientStructure::structure))
                            .orElseThrow();
                    double ml = MeshMeasure.signedVolumeMl(shown);
                    return new Ratio(
                            like,
                            ml,
                            ml / MeshMeasure.signedVolumeMl(mesh),
                            lengthMm(shown) / lengthMm(mesh),
                            parts.stream().allMatch(PatientStructure::isComplete));
                });
    }

    /** Longest edge of the bounding box, mm. */
    private static double lengthMm(TriangleMesh mesh) {
        double[] box = mesh.bounds();
        return Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
    }

    /**
     * Size of a structure of the scan.
     *
     * @param structure one of its parts
     * @param ml volume of all parts
     * @param toTemplate the same over the template's
     * @param length their length over the template's
     * @param complete whether no part is cut off
     */
    private record Ratio(Structure structure, double ml, double toTemplate, double length, boolean complete) {
        /** @param size volume of the body over that of the template */
        boolean isFragment(double size) {
            double least = structure.level() >= FIRST_FLOATING ? LEAST_LENGTH_FLOATING : LEAST_LENGTH;
            boolean isShort = structure.kind() == StructureKind.RIB && length < StrictMath.cbrt(size) * least;
            return isShort || toTemplate < size * LEAST_SHARES.get(structure.kind());
        }
    }
}
