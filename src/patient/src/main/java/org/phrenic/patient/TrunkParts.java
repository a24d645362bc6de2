package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.LevelClip;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.label.LabelTable;

/**
 * What the skin of the trunk encloses: everything but the limbs, the head, lesions and structures of unknown names. A
 * target volume may reach out of the body, and an unknown structure may be a couch or a bolus. Of the bone at the root
 * of a limb it is the part within {@value #ROOT_MM} mm of the bone of the trunk that carries it, of bones or muscles
 * under one label the part so near to the rest of the trunk: an arm beside the trunk would widen the skin of the flank.
 * Muscles in front of the trunk and behind it belong to it wherever they are, as the wall of the belly, where they hang
 * together with what is near.
 */
final class TrunkParts {
    private static final double ROOT_MM = 40;

    /** Bones at the roots of the limbs, by the first word of their names, and the bones that carry them. */
    private static final Map<String, String> CARRIERS = Map.of("humerus", "scapula", "femur", "hip");

    /** First words of the names of all else of the limbs and the head. */
    private static final Set<String> OUTSIDE = Set.of(
            "radius",
            "ulna",
            "carpal",
            "metacarpal",
            "phalanges",
            "patella",
            "tibia",
            "fibula",
            "tarsal",
            "metatarsal",
            "quadriceps",
            "sartorius",
            "thigh",
            "skull",
            "brain",
            "face",
            "head",
            "eye",
            "mandible");

    /** Words of a name that tell a side. */
    private static final Set<String> SIDES = Set.of("left", "right");

    /** Names of bones and muscles of trunk and limbs under one label. */
    private static final Set<String> OF_WHOLE_BODY =
            Set.of(OrganNames.words(LabelTable.ALL_BONES), OrganNames.words("muscle_skeletal"));

    private final List<TriangleTree> carriers;
    /** Ends of the trunk across and along the body, mm; none for bones. */
    private final Optional<double[]> front;

    private TrunkParts(List<Structure> carriers, Optional<double[]> front) {
        this.carriers = carriers.stream().map(s -> new TriangleTree(s.mesh())).toList();
        this.front = front;
    }

    /** The structures of the trunk and the roots of the limbs. */
    static List<Structure> of(List<Structure> body) {
        List<Structure> trunk = body.stream()
                .filter(s -> !TemplateParts.isOfOnePerson(s))
                .filter(s ->
                        !CARRIERS.containsKey(firstWord(s)) && !OUTSIDE.contains(firstWord(s)) && !isOfWholeBody(s))
                .toList();
        List<Structure> parts = new ArrayList<>(trunk);
        for (Structure s : body) {
            if (isOfWholeBody(s)) {
                Optional<double[]> front = s.kind() == StructureKind.MUSCLE ? front(trunk) : Optional.empty();
                new TrunkParts(trunk, front).part(s).ifPresent(parts::add);
            } else if (CARRIERS.containsKey(firstWord(s))) {
                List<Structure> carriers = named(CARRIERS.get(firstWord(s)), body);
                new TrunkParts(carriers, Optional.empty()).part(s).ifPresent(parts::add);
            }
        }
        return parts;
    }

    /** The breadth of the ribs, and the height from the lower end of the trunk to the upper one of the ribs. */
    private static Optional<double[]> front(List<Structure> trunk) {
        Optional<double[]> ribs = PatientBody.bounds(trunk.stream().filter(s -> s.kind() == StructureKind.RIB));
        ribs.ifPresent(box -> box[2] = DoubleStream.concat(
                        trunk.stream().mapToDouble(s -> s.mesh().bounds()[2]),
                        TrunkSection.of(trunk).stream().mapToDouble(TrunkSection::z))
                .min()
                .orElseThrow());
        return ribs;
    }

    private static boolean isOfWholeBody(Structure s) {
        return OF_WHOLE_BODY.contains(OrganNames.words(s.name()));
    }

    private static List<Structure> named(String word, List<Structure> body) {
        return body.stream().filter(s -> firstWord(s).equals(word)).toList();
    }

    /** First word of a name that tells no side. */
    private static String firstWord(Structure s) {
        return Arrays.stream(OrganNames.words(s.name()).split(" "))
                .filter(word -> !SIDES.contains(word))
                .findFirst()
                .orElse("");
    }

    /** The part of a structure near its carriers, and in front and behind with it; empty if there is none. */
    private Optional<Structure> part(Structure limb) {
        double[] values = nearness(limb.mesh());
        front.ifPresent(box -> Arrays.setAll(values, v -> Math.max(values[v], depth(limb.mesh(), v, box))));
        TriangleMesh part = LevelClip.positivePart(limb.mesh(), values);
        List<TriangleMesh> pieces = front.isEmpty()
                ? List.of(part)
                : ConnectedComponents.of(part).stream()
                        .filter(piece -> Arrays.stream(nearness(piece)).anyMatch(near -> near > 0))
                        .toList();
        TriangleMesh all = MeshMerge.merge(pieces);
        return all.triangleCount() == 0 ? Optional.empty() : Optional.of(limb.withMesh(all));
    }

    /** Depth of a vertex between the ends of a box across and along the body, mm. */
    private static double depth(TriangleMesh mesh, int v, double[] box) {
        double across = Math.min(mesh.x(v) - box[0], box[3] - mesh.x(v));
        return Math.min(across, Math.min(mesh.z(v) - box[2], box[5] - mesh.z(v)));
    }

    /** How much nearer than {@value #ROOT_MM} mm each vertex is to one of the carriers, mm. */
    private double[] nearness(TriangleMesh mesh) {
        double[] values = new double[mesh.vertexCount()];
        Arrays.fill(values, -ROOT_MM);
        carriers.forEach(tree -> {
            double[] distances = tree.distances(mesh.positions());
            Arrays.setAll(values, v -> Math.max(values[v], ROOT_MM - distances[v]));
        });
        return values;
    }
}
