package org.phrenic.fit;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Surface;

/** What of a body a target is a surface of. */
public enum FitPart {
    LUNGS("lungs", StructureKind.LUNG, null, false),
    LUNG_RIGHT("lung_R", StructureKind.LUNG, Side.RIGHT, false),
    LUNG_LEFT("lung_L", StructureKind.LUNG, Side.LEFT, false),
    LUNG_BASE_RIGHT("lung_base_R", StructureKind.LUNG, Side.RIGHT, true),
    LUNG_BASE_LEFT("lung_base_L", StructureKind.LUNG, Side.LEFT, true),
    DIAPHRAGM("diaphragm", StructureKind.DIAPHRAGM, null, false),
    LIVER("liver", StructureKind.LIVER, null, false);

    private final String label;
    private final StructureKind kind;
    private final Side side;
    private final boolean base;

    FitPart(String label, StructureKind kind, Side side, boolean base) {
        this.label = label;
        this.kind = kind;
        this.side = side;
        this.base = base;
    }

    /** As it is written on the command line. */
    public String label() {
        return label;
    }

    /**
     * Whether only its base counts ({@link org.phrenic.patient.LungBaseFacet}): the surface of a lung that lies on the
     * diaphragm.
     */
    public boolean isBase() {
        return base;
    }

    /** The base of a lung; null of what is not one whole lung. */
    FitPart base() {
        return switch (this) {
            case LUNG_RIGHT -> LUNG_BASE_RIGHT;
            case LUNG_LEFT -> LUNG_BASE_LEFT;
            default -> null;
        };
    }

    /** Whether a surface of a scene belongs to it. */
    public boolean matches(Surface surface) {
        return surface.kind() == kind && (side == null || surface.side() == side);
    }

    /** The part of this label; empty if there is none. */
    public static Optional<FitPart> of(String label) {
        return Arrays.stream(values()).filter(p -> p.label.equals(label)).findFirst();
    }

    /** All labels, with commas. */
    public static String labels() {
        return labelList().stream().collect(Collectors.joining(", "));
    }

    static List<String> labelList() {
        return Arrays.stream(values()).map(FitPart::label).toList();
    }
}
