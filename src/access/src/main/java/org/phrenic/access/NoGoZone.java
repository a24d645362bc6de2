package org.phrenic.access;

import java.util.Collection;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;

/** What a needle should keep out of. */
public enum NoGoZone {
    LUNG("lung"),
    /** Rib, costal cartilage, sternum, vertebra, disc. */
    BONE("bone"),
    /** The zone below a rib's lower border, where intercostal vessels and nerve run ({@link CostalGroove}). */
    VESSELS("vessels below a rib"),
    /** The pleural recess ({@link PleuralReflection}). */
    PLEURA("pleural recess"),
    /** What the body has besides: trachea, bowel. */
    ORGAN("other organ");

    private final String label;

    NoGoZone(String label) {
        this.label = label;
    }

    /**
     * What a path may not touch unless it is said otherwise. The recess is not among it: in the 7th to 9th space it can
     * hardly be avoided; that it is crossed is reported.
     */
    public static Set<NoGoZone> defaults() {
        return EnumSet.of(LUNG, BONE, VESSELS, ORGAN);
    }

    /** What a structure of this kind is; empty for what a needle passes on its way. */
    public static Optional<NoGoZone> of(StructureKind kind) {
        return switch (kind) {
            case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC -> Optional.of(BONE);
            case LUNG -> Optional.of(LUNG);
            case OTHER -> Optional.of(ORGAN);
            case DIAPHRAGM, LIVER, SKIN -> Optional.empty();
        };
    }

    /** Name for people. */
    public String label() {
        return label;
    }

    /** Name in a file. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    public int bit() {
        return 1 << ordinal();
    }

    public static int bits(Collection<NoGoZone> all) {
        return all.stream().mapToInt(NoGoZone::bit).reduce(0, (a, b) -> a | b);
    }

    public static Set<NoGoZone> of(int bits) {
        Set<NoGoZone> all = EnumSet.noneOf(NoGoZone.class);
        for (NoGoZone one : values()) {
            if ((bits & one.bit()) != 0) {
                all.add(one);
            }
        }
        return all;
    }
}
