package org.phrenic.access;

import java.util.Locale;
import org.phrenic.anatomy.Side;
import org.phrenic.simulation.observe.Surface;

/** Names of structures for people. */
final class StructureLabel {
    private StructureLabel() {}

    /** "right rib 8", "left lung", "liver". */
    static String of(Surface surface) {
        String side =
                surface.side() == Side.MIDLINE ? "" : surface.side().name().toLowerCase(Locale.ROOT) + " ";
        return switch (surface.kind()) {
            case RIB -> side + "rib " + surface.level();
            case COSTAL_CARTILAGE -> side + "costal cartilage " + surface.level();
            case LUNG -> side + "lung";
            case LIVER -> "liver";
            case DIAPHRAGM -> "diaphragm";
            case SKIN -> "skin";
            case STERNUM, VERTEBRA, DISC, OTHER -> surface.name().replace('_', ' ');
        };
    }
}
