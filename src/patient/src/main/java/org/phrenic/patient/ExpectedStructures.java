package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.Numbers;

/** The structures expected in a complete thorax. */
public final class ExpectedStructures {
    private static final int RIBS = 12;
    private static final int CARTILAGES = 10;
    private static final int THORACIC_VERTEBRAE = 12;

    private ExpectedStructures() {}

    /** Names of missing structures. For sternum and skin, any part is sufficient. */
    public static List<String> missing(List<PatientStructure> present) {
        List<String> missing = new ArrayList<>();
        levels(present, missing, StructureKind.RIB, "rib", RIBS);
        levels(present, missing, StructureKind.COSTAL_CARTILAGE, "costal_cartilage", CARTILAGES);
        for (int level = 1; level <= THORACIC_VERTEBRAE; level++) {
            String name = Numbers.format("vertebra_T%02d", level);
            check(present, missing, StructureKind.VERTEBRA, level, Side.MIDLINE, name);
        }
        check(present, missing, StructureKind.LUNG, 0, Side.RIGHT, "lung_R");
        check(present, missing, StructureKind.LUNG, 0, Side.LEFT, "lung_L");
        for (StructureKind kind :
                List.of(StructureKind.STERNUM, StructureKind.DIAPHRAGM, StructureKind.LIVER, StructureKind.SKIN)) {
            check(present, missing, kind, 0, Side.MIDLINE, kind.name().toLowerCase(Locale.ROOT));
        }
        return missing;
    }

    private static void levels(
            List<PatientStructure> present, List<String> missing, StructureKind kind, String stem, int last) {
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            for (int level = 1; level <= last; level++) {
                String name = Numbers.format("%s_%02d_%s", stem, level, side == Side.RIGHT ? "R" : "L");
                check(present, missing, kind, level, side, name);
            }
        }
    }

    private static void check(
            List<PatientStructure> present,
            List<String> missing,
            StructureKind kind,
            int level,
            Side side,
            String name) {
        if (present.stream()
                .map(PatientStructure::structure)
                .noneMatch(s -> s.kind() == kind && s.level() == level && s.side() == side)) {
            missing.add(name);
        }
    }
}
