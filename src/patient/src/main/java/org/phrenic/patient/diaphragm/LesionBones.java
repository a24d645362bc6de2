package org.phrenic.patient.diaphragm;

import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.phrenic.anatomy.LesionPlace;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.query.TriangleTree;

/** The bones that lesions of bones go with. */
final class LesionBones {
    private static final Set<StructureKind> BONES = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.BONE);

    private final List<Structure> bones;
    /** Of the bones, made when they are first asked for. */
    private List<TriangleTree> trees = List.of();

    LesionBones(Thorax body) {
        bones = body.structures().stream().filter(s -> BONES.contains(s.kind())).toList();
    }

    /** Whether a structure is a lesion of a bone by its name. */
    static boolean isOfBone(Structure s) {
        return s.kind() == StructureKind.LESION && LesionPlace.isInBone(name(s));
    }

    /** The bone nearest to a lesion that may be one of ribs, sternum or cartilages; empty for others, which stay. */
    Optional<Structure> of(Structure lesion) {
        if (!LesionPlace.mayBeInCage(name(lesion))) {
            return Optional.empty();
        }
        double[] means =
                trees().stream().mapToDouble(bone -> meanDistance(lesion, bone)).toArray();
        return IntStream.range(0, means.length)
                .reduce((a, b) -> Double.compare(means[b], means[a]) < 0 ? b : a)
                .stream()
                .mapToObj(bones::get)
                .findFirst();
    }

    private synchronized List<TriangleTree> trees() {
        if (trees.isEmpty()) {
            trees = bones.stream().map(bone -> new TriangleTree(bone.mesh())).toList();
        }
        return trees;
    }

    private static double meanDistance(Structure lesion, TriangleTree bone) {
        double[] all = bone.distances(lesion.mesh().positions());
        double sum = 0;
        for (double d : all) {
            sum += d;
        }
        return sum / all.length;
    }

    private static String name(Structure s) {
        return s.name().toLowerCase(Locale.ROOT);
    }
}
