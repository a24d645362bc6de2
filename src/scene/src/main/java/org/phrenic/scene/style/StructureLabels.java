package org.phrenic.scene.style;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.simulation.observe.Surface;

/** Display names of structures, such as "Rib 5 right" for {@code rib_05_R}. */
public final class StructureLabels {
    /** Number of a vertebra in small letters. */
    private static final Pattern VERTEBRAL = Pattern.compile("[ctls]\\d+");

    private static final Pattern NUMBER = Pattern.compile("\\d+");

    private static final Set<String> LOBES = Set.of("upper", "middle", "lower");

    private StructureLabels() {}

    public static String of(Surface surface) {
        return of(surface.name());
    }

    /** Display name of the structure called {@code name} in files. */
    public static String of(String name) {
        Optional<StructureName> known = StructureName.parse(name);
        if (known.isEmpty()) {
            return capitalized(name);
        }
        StructureName s = known.get();
        return switch (s.kind()) {
            case RIB -> "Rib " + s.level() + side(s.side());
            case COSTAL_CARTILAGE -> "Costal cartilage " + s.level() + side(s.side());
            case VERTEBRA -> "Vertebra " + level(s.level());
            case DISC -> s.level() == 0 ? "Disc C7-T1" : "Disc " + level(s.level()) + "-" + below(s.level());
            case LUNG -> lung(name, s.side());
            case SKIN -> "Skin" + piece(name).orElse("");
            case PLEURA -> "Pleura" + side(s.side());
            case STERNUM, DIAPHRAGM, LIVER -> capitalized(name);
            default -> vertebral(capitalized(OrganNames.words(name))) + side(s.side());
        };
    }

    /** Words whose last, if it numbers a vertebra, has a capital letter: "Vertebra C7". */
    private static String vertebral(String words) {
        int last = words.lastIndexOf(' ') + 1;
        return VERTEBRAL.matcher(words.substring(last)).matches()
                ? words.substring(0, last) + words.substring(last).toUpperCase(Locale.ROOT)
                : words;
    }

    /** Plural display name of a kind of structure, for lists: "Ribs". */
    public static String of(StructureKind kind) {
        return switch (kind) {
            case RIB -> "Ribs";
            case COSTAL_CARTILAGE -> "Costal cartilages";
            case STERNUM -> "Sternum";
            case VERTEBRA -> "Vertebrae";
            case DISC -> "Discs";
            case DIAPHRAGM -> "Diaphragm";
            case LUNG -> "Lungs";
            case LIVER -> "Liver";
            case SKIN -> "Skin";
            case PLEURA -> "Pleura";
            case ORGAN -> "Organs";
            case VESSEL -> "Vessels";
            case MUSCLE -> "Muscles";
            case BONE -> "Other bones";
            case LESION -> "Lesions";
            case OTHER -> "Other";
        };
    }

    private static String lung(String name, Side side) {
        String[] parts = name.split("_", 3);
        String part = parts.length > 2 ? parts[2].toLowerCase(Locale.ROOT) : "";
        String stem = part.replaceFirst("(^|_)\\d+$", "");
        if (stem.isEmpty() || LOBES.contains(stem)) {
            String lobe = stem.isEmpty() ? "" : ", " + stem + " lobe";
            return "Lung" + side(side) + lobe + piece(name).orElse("");
        }
        return "Lung" + side(side) + ", " + part.replace('_', ' ');
    }

    /** Which of several pieces a structure is, as in {@code lung_R_2}. */
    private static Optional<String> piece(String name) {
        String last = name.substring(name.lastIndexOf('_') + 1);
        return NUMBER.matcher(last).matches() ? Optional.of(", piece " + last) : Optional.empty();
    }

    private static String side(Side side) {
        return side == Side.MIDLINE ? "" : " " + side.name().toLowerCase(Locale.ROOT);
    }

    private static String level(int level) {
        return level < StructureName.FIRST_LUMBAR ? "T" + level : "L" + (level - StructureName.FIRST_LUMBAR + 1);
    }

    private static String below(int level) {
        return level == StructureName.FIRST_LUMBAR + 4 ? "S1" : level(level + 1);
    }

    private static String capitalized(String name) {
        String words = name.replace('_', ' ').strip();
        return words.isEmpty() ? name : words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }
}
