package org.phrenic.access;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.query.TriangleTree;

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
        TriangleTree liver = new TriangleTree(body.liver().surface().rest());
        List<ScannedLesion> lesions = new ArrayList<>();
        for (MovingStructure structure : body.structures()) {
            if (structure.surface().kind() == StructureKind.LESION) {
                addPieces(structure, liver, lesions);
            }
        }
        lesions.sort(Comparator.comparingDouble((ScannedLesion lesion) -> -lesion.target.diameterMm())
                .thenComparing(ScannedLesion::name));
        return List.copyOf(lesions);
    }

    private static void addPieces(MovingStructure structure, TriangleTree liver, List<ScannedLesion> lesions) {
        List<TriangleMesh> pieces = ConnectedComponents.of(structure.surface().rest()).stream()
                .filter(piece -> MeshMeasure.signedVolume(piece) > 0)
                .sorted(Comparator.comparingDouble((TriangleMesh piece) -> -MeshMeasure.signedVolume(piece)))
                .toList();
        for (int i = 0; i < pieces.size(); i++) {
            TargetLesion target = sphere(pieces.get(i));
            double[] centre = target.restMm();
            if (liver.isInside(centre[0], centre[1], centre[2])) {
                String name = structure.surface().name() + (i == 0 ? "" : "#" + (i + 1));
                String label = structure.label() + (i == 0 ? "" : " " + (i + 1));
                lesions.add(new ScannedLesion(name, label, target));
            }
        }
    }

    /** The sphere of a closed surface, of a size that a target may have. */
    private static TargetLesion sphere(TriangleMesh piece) {
        double diameter = StrictMath.cbrt(6 / Math.PI * MeshMeasure.signedVolume(piece));
        return new TargetLesion(
                MeshMeasure.centreOfMass(piece),
                Math.max(TargetLesion.SMALLEST_MM, Math.min(TargetLesion.LARGEST_MM, diameter)));
    }

    /**
     * The lesion of a name.
     *
     * @throws BadInputException if there is none in the liver
     */
    public static ScannedLesion named(MovingAnatomy body, String name) {
        List<ScannedLesion> all = of(body);
        String names = all.stream().map(ScannedLesion::name).collect(Collectors.joining(", "));
        return all.stream()
                .filter(lesion -> lesion.name.equalsIgnoreCase(name))
                .findFirst()
                .orElseThrow(
                        () -> new BadInputException("target: found no lesion '" + name + "' in the liver, expected "
                                + (names.isEmpty() ? "a body that shows one" : "one of " + names)));
    }
}
