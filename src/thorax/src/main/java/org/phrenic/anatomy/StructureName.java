package org.phrenic.anatomy;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.FileNames;
import org.phrenic.file.Numbers;

/**
 * Kind, level and side of a structure, parsed from its name: {@code rib_05_R}, {@code costal_cartilage_02_L},
 * {@code sternum_body}, {@code vertebra_T06}, {@code disc_T4_T5}, {@code lung_R_middle}, {@code pleura_R},
 * {@code diaphragm}, {@code liver}, {@code skin_torso}, and the names of {@link OrganNames}. Case and leading zeros are
 * ignored.
 *
 * @param kind kind of structure
 * @param level as in {@link Structure}
 * @param side side of the body
 */
public record StructureName(StructureKind kind, int level, Side side) {
    /** Level of the first lumbar vertebra, after the twelve thoracic ones. */
    public static final int FIRST_LUMBAR = 13;

    private static final int LAST_CERVICAL = 7;
    private static final int LAST_LUMBAR = 5;

    private static final Pattern LEVELLED = Pattern.compile("(rib|costal_cartilage)_0*(\\d{1,2})_([rl])");
    private static final Pattern VERTEBRA = Pattern.compile("vertebra_([tl])0*(\\d{1,2})");
    private static final Pattern DISC = Pattern.compile("disc_([ctl])0*(\\d{1,2})_[tls]0*\\d{1,2}");
    private static final Pattern LUNG = Pattern.compile("(lung|pleura)_([rl])(_.*)?");
    /** Names of vertebrae and discs, whose regions are capitals. */
    private static final Pattern SPINAL = Pattern.compile("((?:bone_)?vertebra_|disc_)([ctls]\\d.*)");

    private static final Pattern SUFFIX = Pattern.compile("_[rl](?=_|$)");

    /** Parses a name; empty if the name is unknown, or none of a file. */
    public static Optional<StructureName> parse(String name) {
        if (!FileNames.isPortable(name)) {
            return Optional.empty();
        }
        String n = name.toLowerCase(Locale.ROOT);
        Matcher m = LEVELLED.matcher(n);
        if (m.matches()) {
            int level = Integer.parseInt(m.group(2));
            StructureKind kind = m.group(1).equals("rib") ? StructureKind.RIB : StructureKind.COSTAL_CARTILAGE;
            boolean known = level >= 1 && level <= (kind == StructureKind.RIB ? 12 : 10);
            return known ? Optional.of(new StructureName(kind, level, side(m.group(3)))) : Optional.empty();
        }
        m = VERTEBRA.matcher(n);
        if (m.matches()) {
            return spinal(StructureKind.VERTEBRA, m.group(1), m.group(2));
        }
        m = DISC.matcher(n);
        if (m.matches()) {
            return spinal(StructureKind.DISC, m.group(1), m.group(2));
        }
        m = LUNG.matcher(n);
        if (m.matches()) {
            StructureKind kind = m.group(1).equals("lung") ? StructureKind.LUNG : StructureKind.PLEURA;
            return Optional.of(new StructureName(kind, 0, side(m.group(2))));
        }
        StructureKind kind = null;
        if (n.startsWith("sternum")) {
            kind = StructureKind.STERNUM;
        } else if (n.equals("diaphragm")) {
            kind = StructureKind.DIAPHRAGM;
        } else if (n.equals("liver")) {
            kind = StructureKind.LIVER;
        } else if (n.startsWith("skin")) {
            kind = StructureKind.SKIN;
        }
        return kind == null ? OrganNames.parse(name) : Optional.of(new StructureName(kind, 0, Side.MIDLINE));
    }

    /**
     * The usual spelling of a name, by which other code finds the structure: {@code Rib_5_r} is {@code rib_05_R}. Text
     * that is no structure's name stays as it is.
     */
    public static String usual(String name) {
        return parse(name)
                .map(known -> known.spelling(name.toLowerCase(Locale.ROOT)))
                .orElse(name);
    }

    private String spelling(String lower) {
        return switch (kind) {
            case RIB, COSTAL_CARTILAGE ->
                Numbers.format(
                        "%s_%02d_%s", kind.name().toLowerCase(Locale.ROOT), level, side == Side.RIGHT ? "R" : "L");
            case VERTEBRA ->
                level < FIRST_LUMBAR
                        ? Numbers.format("vertebra_T%02d", level)
                        : Numbers.format("vertebra_L%02d", level - FIRST_LUMBAR + 1);
            default -> {
                Matcher spinal = SPINAL.matcher(lower);
                yield spinal.matches()
                        ? spinal.group(1)
                                + spinal.group(2).toUpperCase(Locale.ROOT).replaceAll("(?<=[CTLS])0+(?=\\d)", "")
                        : SUFFIX.matcher(lower).replaceFirst(m -> m.group().toUpperCase(Locale.ROOT));
            }
        };
    }

    private static Side side(String letter) {
        return letter.equals("r") ? Side.RIGHT : Side.LEFT;
    }

    /** Level in the spine. A disc has the level of the vertebra above it; the disc C7/T1 has level 0. */
    private static Optional<StructureName> spinal(StructureKind kind, String region, String number) {
        int n = Integer.parseInt(number);
        boolean known =
                switch (region) {
                    case "c" -> n == LAST_CERVICAL;
                    case "t" -> n >= 1 && n < FIRST_LUMBAR;
                    default -> n >= 1 && n <= LAST_LUMBAR;
                };
        int level =
                switch (region) {
                    case "c" -> 0;
                    case "t" -> n;
                    default -> FIRST_LUMBAR - 1 + n;
                };
        return known ? Optional.of(new StructureName(kind, level, Side.MIDLINE)) : Optional.empty();
    }
}
