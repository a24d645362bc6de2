package org.phrenic.access;

import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.anatomy.StructureKind;

/** Structures that a needle should not touch. */
public enum NoGoZone {
    LUNG("lung"),
    /** Ribs, costal cartilages, sternum, vertebrae, discs and other bones. */
    BONE("bone"),
    /** Zone of the intercostal vessels and nerve below a rib ({@link CostalGroove}). */
    VESSELS("vessels below a rib"),
    /** The pleural recess ({@link PleuralReflection}). */
    PLEURA("pleural recess"),
    /** Any other organ or large vessel, such as gall bladder, bowel or portal vein, and unknown structures. */
    ORGAN("another organ or a vessel");

    private final String label;

    NoGoZone(String label) {
        this.label = label;
    }

    /**
     * Zones to avoid if a plan specifies none. The pleural recess is not included because it can hardly be avoided in
     * the 7th to 9th intercostal space. Crossing it is reported.
     */
    public static Set<NoGoZone> defaults() {
        return EnumSet.of(LUNG, BONE, VESSELS, ORGAN);
    }

    /** The zone of a kind of structure, or empty if a needle may pass through it. */
    public static Optional<NoGoZone> of(StructureKind kind) {
        return switch (kind) {
            case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC, BONE -> Optional.of(BONE);
            case LUNG -> Optional.of(LUNG);
            case ORGAN, VESSEL, OTHER -> Optional.of(ORGAN);
            case DIAPHRAGM, LIVER, SKIN, PLEURA, MUSCLE, LESION -> Optional.empty();
        };
    }

    public String label() {
        return label;
    }

    /** Name of the zone in files. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Mask with the bit of this zone, for use in a bit set. */
    public int bit() {
        return 1 << ordinal();
    }

    /** Converts zones to a bit set. */
    public static int bits(Collection<NoGoZone> zones) {
        return zones.stream().mapToInt(NoGoZone::bit).reduce(0, (a, b) -> a | b);
    }

    /** Converts a bit set to zones. */
    public static Set<NoGoZone> of(int bits) {
        return Arrays.stream(values())
                .filter(zone -> (bits & zone.bit()) != 0)
                .collect(Collectors.toCollection(() -> EnumSet.noneOf(NoGoZone.class)));
    }
}
