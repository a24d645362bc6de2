package org.phrenic.access;

import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.anatomy.StructureKind;

/** What a needle should not touch. */
public enum NoGoZone {
    LUNG("lung"),
    /** Rib, costal cartilage, sternum, vertebra, disc. */
    BONE("bone"),
    /** The zone of the intercostal vessels and nerve below a rib ({@link CostalGroove}). */
    VESSELS("vessels below a rib"),
    /** The pleural recess ({@link PleuralReflection}). */
    PLEURA("pleural recess"),
    /** Any other structure of the body: trachea, bowel. */
    ORGAN("other organ");

    private final String label;

    NoGoZone(String label) {
        this.label = label;
    }

    /**
     * The zones of a plan that names none. The recess is not among them: in the 7th to 9th intercostal space it can
     * hardly be avoided; crossing it is reported.
     */
    public static Set<NoGoZone> defaults() {
        return EnumSet.of(LUNG, BONE, VESSELS, ORGAN);
    }

    /** The zone of a kind of structure; empty for those that a needle may pass. */
    public static Optional<NoGoZone> of(StructureKind kind) {
        return switch (kind) {
            case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC -> Optional.of(BONE);
            case LUNG -> Optional.of(LUNG);
            case OTHER -> Optional.of(ORGAN);
            case DIAPHRAGM, LIVER, SKIN -> Optional.empty();
        };
    }

    /** Display name. */
    public String label() {
        return label;
    }

    /** Name in files. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The bit of the zone in a bit set. */
    public int bit() {
        return 1 << ordinal();
    }

    /** The bit set of zones. */
    public static int bits(Collection<NoGoZone> zones) {
        return zones.stream().mapToInt(NoGoZone::bit).reduce(0, (a, b) -> a | b);
    }

    /** The zones of a bit set. */
    public static Set<NoGoZone> of(int bits) {
        return Arrays.stream(values())
                .filter(zone -> (bits & zone.bit()) != 0)
                .collect(Collectors.toCollection(() -> EnumSet.noneOf(NoGoZone.class)));
    }
}
