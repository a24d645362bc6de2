package org.phrenic.patient.diaphragm;

import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.LesionPlace;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.query.SurfaceDistance;

/** The bones that lesions of bones go with. */
final class LesionBones {
    private static final Set<StructureKind> BONES = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.BONE);

    private final List<Structure> bones;

    LesionBones(Thorax body) {
        bones = body.structures().stream().filter(s -> BONES.contains(s.kind())).toList();
    }

    /** Whether a structure is a lesion of a bone by its name. */
    static boolean isOfBone(Structure s) {
        return s.kind() == StructureKind.LESION && LesionPlace.isInBone(name(s));
    }

    /** The bone nearest to a lesion that may be one of ribs, sternum or cartilages; empty for others, which stay. */
    Optional<Structure> of(Structure lesion) {
        return LesionPlace.mayBeInCage(name(lesion))
                ? bones.stream().min(Comparator.comparingDouble(bone -> meanDistance(lesion, bone)))
                : Optional.empty();
    }

    private static double meanDistance(Structure lesion, Structure bone) {
        double[] distances =
                new SurfaceDistance(bone.mesh()).unsignedDistance(lesion.mesh().positions());
        double sum = 0;
        for (double d : distances) {
            sum += d;
        }
        return sum / distances.length;
    }

    private static String name(Structure s) {
        return s.name().toLowerCase(Locale.ROOT);
    }
}
