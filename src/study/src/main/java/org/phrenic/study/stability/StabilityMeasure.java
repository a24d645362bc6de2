package org.phrenic.study.stability;

import java.util.Locale;

/** Quantities measured in a stability case, each with an optional bound. */
enum StabilityMeasure {
    /** Largest sampled kinetic energy over the largest of the reference solution. */
    KINETIC_FACTOR("kinetic", "kinetic energy over that of the reference solution"),
    /** Largest speed of a node at a sample, mm/s. */
    SPEED_MM_S("mm/s", "speed of a node, mm/s"),
    /** Largest distance of a node from its start, mm. */
    REACH_MM("reach mm", "distance of a node from its start, mm"),
    /** Rms distance of all nodes from the reference solution at the same time, over that solution's excursion. */
    SHAPE("shape", "rms distance from the reference solution over its excursion"),
    /** Largest | |AB| - L | / L of a rigid link. */
    LINK_ERROR("links", "error of a link's length"),
    /** Greatest distance of a vertex of the sheet outside the chest wall at a sample, mm. */
    OUTSIDE_MM("outside mm", "distance of a vertex outside the chest wall, mm"),
    /** Greatest distance by which the two faces of the sheet pass each other at a sample, mm. */
    CROSSED_MM("crossed mm", "distance by which the faces of the sheet cross, mm"),
    /** Rms distance of all nodes from the start at the end of the case, mm. */
    RETURN_MM("return mm", "rms distance from the start at the end, mm"),
    /** Distance of a node between the end of a period and the end of the first period after one minute, mm. */
    REPEAT_MM("repeat mm", "distance of a node from where an earlier breath left it, mm"),
    /** Distance of a node from its start after the breath was stopped and the body came to rest, mm. */
    DRIFT_MM("drift mm", "drift of a node of the rest shape, mm");

    private final String heading;
    private final String description;

    StabilityMeasure(String heading, String description) {
        this.heading = heading;
        this.description = description;
    }

    /** Column name in CSV and field name in JSON. */
    String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    String heading() {
        return heading;
    }

    String description() {
        return description;
    }
}
