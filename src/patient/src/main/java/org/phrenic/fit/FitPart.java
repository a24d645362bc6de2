package org.phrenic.fit;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Surface;

/** Part of the body that a target describes. */
public enum FitPart {
    LUNGS("lungs", StructureKind.LUNG, null),
    LUNG_RIGHT("lung_R", StructureKind.LUNG, Side.RIGHT),
    LUNG_LEFT("lung_L", StructureKind.LUNG, Side.LEFT),
    LUNG_BASE_RIGHT("lung_base_R", StructureKind.LUNG, Side.RIGHT),
    LUNG_BASE_LEFT("lung_base_L", StructureKind.LUNG, Side.LEFT),
    DIAPHRAGM("diaphragm", StructureKind.DIAPHRAGM, null),
    LIVER("liver", StructureKind.LIVER, null);

    private final String label;
    private final StructureKind kind;
    private final Side side;

    FitPart(String label, StructureKind kind, Side side) {
        this.label = label;
        this.kind = kind;
        this.side = side;
    }

    /** Name on the command line and in files. */
    public String label() {
        return label;
    }

    /** Whether the part is the base of a lung ({@link org.phrenic.patient.registration.DiaphragmaticSurface}). */
    public boolean isBase() {
        return this == LUNG_BASE_RIGHT || this == LUNG_BASE_LEFT;
    }

    /** The base of a whole lung, or null for other parts. */
    FitPart base() {
        return this == LUNG_RIGHT ? LUNG_BASE_RIGHT : this == LUNG_LEFT ? LUNG_BASE_LEFT : null;
    }

    /** Whether a surface of a scene belongs to the part. */
    public boolean matches(Surface surface) {
        return surface.kind() == kind && (side == null || surface.side() == side);
    }

    /** The part with this label, or empty. */
    public static Optional<FitPart> of(String label) {
        return Arrays.stream(values()).filter(p -> p.label.equals(label)).findFirst();
    }

    /** All labels, separated by commas. */
    public static String labels() {
        return Arrays.stream(values()).map(FitPart::label).collect(Collectors.joining(", "));
    }
}
