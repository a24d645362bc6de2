package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.LevelClip;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.label.LabelTable;

/**
 * What the skin of the trunk encloses: everything but the limbs, the head, lesions and structures of unknown names. A
 * target volume may reach out of the body, and an unknown structure may be a couch or a bolus. Of the bone at the root
 * of a limb it is the part within {@value #ROOT_MM} mm of the bone of the trunk that carries it, of bones or muscles
 * under one label the part so near to the rest of the trunk: an arm beside the trunk would widen the skin of the flank.
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

    private TrunkParts() {}

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
                near(s, trunk).ifPresent(parts::add);
            } else if (CARRIERS.containsKey(firstWord(s))) {
                near(s, named(CARRIERS.get(firstWord(s)), body)).ifPresent(parts::add);
            }
        }
        return parts;
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

    /** The part of a structure near others; empty if there is none. */
    private static Optional<Structure> near(Structure limb, List<Structure> carriers) {
        double[] values = new double[limb.mesh().vertexCount()];
        Arrays.fill(values, -ROOT_MM);
        carriers.forEach(bone -> {
            double[] distances =
                    new TriangleTree(bone.mesh()).distances(limb.mesh().positions());
            Arrays.setAll(values, v -> Math.max(values[v], ROOT_MM - distances[v]));
        });
        TriangleMesh near = LevelClip.positivePart(limb.mesh(), values);
        return near.triangleCount() == 0 ? Optional.empty() : Optional.of(limb.withMesh(near));
    }
}
