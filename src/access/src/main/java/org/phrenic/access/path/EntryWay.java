package org.phrenic.access.path;

import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.Side;

/**
 * The way by which a path enters the trunk.
 *
 * @param space the intercostal space, for an intercostal way
 */
public record EntryWay(Kind kind, Side side, Optional<IntercostalSpace> space) {
    /** Kinds of ways to the liver. */
    public enum Kind {
        /** Between two neighbouring ribs or their cartilages. */
        INTERCOSTAL,
        /** Below the costal margin. */
        SUBCOSTAL,
        /** Below the xiphoid process, between the costal margins. */
        SUBXIPHOID,
        /** Over a rib or where the cartilages of the costal margin join. */
        AT_RIB
    }

    static EntryWay of(Kind kind, Side side) {
        return new EntryWay(kind, side, Optional.empty());
    }

    /** Name of the way, such as "7th intercostal space, right", "right subcostal" or "subxiphoid". */
    public String label() {
        return switch (kind) {
            case INTERCOSTAL -> space.orElseThrow().label();
            case SUBCOSTAL -> side.name().toLowerCase(Locale.ROOT) + " subcostal";
            case SUBXIPHOID -> "subxiphoid";
            case AT_RIB -> "over a rib or the costal margin";
        };
    }
}
