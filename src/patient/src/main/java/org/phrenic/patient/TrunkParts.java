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

/**
 * What the skin of the trunk encloses: everything but the limbs and the head. Of the bone at the root of a limb it is
 * the part within {@value #ROOT_MM} mm of the bone of the trunk that carries it: an arm beside the trunk would widen
 * the skin of the flank.
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

    private TrunkParts() {}

    /** The structures of the trunk and the roots of the limbs. */
    static List<Structure> of(List<Structure> body) {
        List<Structure> parts = new ArrayList<>();
        for (Structure s : body) {
            String word = firstWord(s);
            if (CARRIERS.containsKey(word)) {
                root(s, CARRIERS.get(word), body).ifPresent(parts::add);
            } else if (!OUTSIDE.contains(word)) {
                parts.add(s);
            }
        }
        return parts;
    }

    private static String firstWord(Structure s) {
        return OrganNames.words(s.name()).split(" ", 2)[0];
    }

    private static Optional<Structure> root(Structure limb, String carrier, List<Structure> body) {
        double[] values = new double[limb.mesh().vertexCount()];
        Arrays.fill(values, -ROOT_MM);
        body.stream().filter(s -> firstWord(s).equals(carrier)).forEach(bone -> {
            double[] distances =
                    new TriangleTree(bone.mesh()).distances(limb.mesh().positions());
            Arrays.setAll(values, v -> Math.max(values[v], ROOT_MM - distances[v]));
        });
        TriangleMesh near = LevelClip.positivePart(limb.mesh(), values);
        return near.triangleCount() == 0 ? Optional.empty() : Optional.of(limb.withMesh(near));
    }
}
