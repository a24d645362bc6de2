package org.phrenic.access;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;

/**
 * A lesion of the liver that the body shows, such as a tumour that a scan labels, as a target: a sphere of its volume
 * about its centre of mass. Each piece of a surface is a lesion.
 *
 * @param name name of the structure; of its second largest piece with {@code #2}, and so on
 * @param label the name in words
 */
public record ScannedLesion(String name, String label, TargetLesion target) {
    /** The lesions whose centres lie in the liver, the largest first. */
    public static List<ScannedLesion> of(MovingAnatomy body) {
        List<ScannedLesion> lesions = new ArrayList<>();
        for (MovingStructure structure : body.structures()) {
            if (structure.surface().kind() == StructureKind.LESION) {
                addPieces(body, structure, lesions);
            }
        }
        lesions.sort(Comparator.comparingDouble((ScannedLesion lesion) -> -lesion.target.diameterMm())
                .thenComparing(ScannedLesion::name));
        return List.copyOf(lesions);
    }

    private static void addPieces(MovingAnatomy body, MovingStructure structure, List<ScannedLesion> lesions) {
        List<TriangleMesh> pieces = ConnectedComponents.of(structure.surface().rest()).stream()
                .filter(piece -> MeshMeasure.signedVolume(piece) > 0)
                .sorted(Comparator.comparingDouble((TriangleMesh piece) -> -MeshMeasure.signedVolume(piece)))
                .toList();
        for (int i = 0; i < pieces.size(); i++) {
            String number = i == 0 ? "" : "#" + (i + 1);
            String name = structure.surface().name() + number;
            String label = structure.label() + (i == 0 ? "" : " " + (i + 1));
            target(body, pieces.get(i)).ifPresent(target -> lesions.add(new ScannedLesion(name, label, target)));
        }
    }

    /** The sphere of a closed surface; empty if its centre lies outside of the liver. */
    private static Optional<TargetLesion> target(MovingAnatomy body, TriangleMesh piece) {
        double diameter = Math.cbrt(6 / Math.PI * MeshMeasure.signedVolume(piece));
        double fitting = Math.max(TargetLesion.SMALLEST_MM, Math.min(TargetLesion.LARGEST_MM, diameter));
        double[] centre = MeshMeasure.centreOfMass(piece);
        return TargetLesion.isInLiver(body, centre)
                ? Optional.of(TargetLesion.at(body, centre, fitting))
                : Optional.empty();
    }

    /**
     * The lesion of a name.
     *
     * @throws BadInputException if there is none in the liver
     */
    public static ScannedLesion named(MovingAnatomy body, String name) {
        List<ScannedLesion> all = of(body);
        return all.stream()
                .filter(lesion -> lesion.name.equalsIgnoreCase(name))
                .findFirst()
                .orElseThrow(
                        () -> new BadInputException("target: found no lesion '" + name + "' in the liver, expected "
                                + (all.isEmpty()
                                        ? "a body that shows one"
                                        : "one of "
                                                + String.join(
                                                        ", ",
                                                        all.stream()
                                                                .map(ScannedLesion::name)
                                                                .toList()))));
    }
}
