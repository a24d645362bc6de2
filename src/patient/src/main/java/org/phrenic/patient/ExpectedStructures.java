package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;

/** What a whole thorax has, and what of it is not there. */
public final class ExpectedStructures {
    private static final int RIBS = 12;
    private static final int CARTILAGES = 10;
    private static final int THORACIC = 12;

    private ExpectedStructures() {}

    /** Names of structures that no organ is; of sternum and skin, any part will do. */
    public static List<String> missing(List<PatientStructure> organs) {
        List<String> missing = new ArrayList<>();
        levels(organs, missing, StructureKind.RIB, "rib", RIBS);
        levels(organs, missing, StructureKind.COSTAL_CARTILAGE, "costal_cartilage", CARTILAGES);
        for (int level = 1; level <= THORACIC; level++) {
            if (!has(organs, StructureKind.VERTEBRA, level, Side.MIDLINE)) {
                missing.add(String.format(Locale.ROOT, "vertebra_T%02d", level));
            }
        }
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            if (!has(organs, StructureKind.LUNG, 0, side)) {
                missing.add("lung_" + letter(side));
            }
        }
        for (StructureKind kind :
                List.of(StructureKind.STERNUM, StructureKind.DIAPHRAGM, StructureKind.LIVER, StructureKind.SKIN)) {
            if (!has(organs, kind, 0, Side.MIDLINE)) {
                missing.add(kind.name().toLowerCase(Locale.ROOT));
            }
        }
        return missing;
    }

    private static void levels(
            List<PatientStructure> organs, List<String> missing, StructureKind kind, String stem, int last) {
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            for (int level = 1; level <= last; level++) {
                if (!has(organs, kind, level, side)) {
                    missing.add(String.format(Locale.ROOT, "%s_%02d_%s", stem, level, letter(side)));
                }
            }
        }
    }

    private static String letter(Side side) {
        return side == Side.RIGHT ? "R" : "L";
    }

    private static boolean has(List<PatientStructure> organs, StructureKind kind, int level, Side side) {
        return organs.stream()
                .map(PatientStructure::structure)
                .anyMatch(s -> s.kind() == kind && s.level() == level && s.side() == side);
    }
}
