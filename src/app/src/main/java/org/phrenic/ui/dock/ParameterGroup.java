package org.phrenic.ui.dock;

import org.phrenic.parameter.Parameter;

/** What the rows of the parameter dock are gathered under. */
enum ParameterGroup {
    MODEL("Model"),
    MUSCLE("Muscle"),
    TISSUE("Tendon and tissue"),
    BREATHING("Breathing"),
    RIBS("Ribs and sternum"),
    NUMERICS("Numerics");

    private final String label;

    ParameterGroup(String label) {
        this.label = label;
    }

    String label() {
        return label;
    }

    /** The group of a parameter. */
    static ParameterGroup of(Parameter parameter) {
        return switch (parameter) {
            case MUSCLE_STIFFNESS, MUSCLE_ACTIVATION, LEFT_OVER_RIGHT, FRONT_OVER_BACK, MUSCLE_FORCE, ACTION_RADIUS ->
                MUSCLE;
            case TENDON_RATIO,
                    SPRING_STIFFNESS,
                    NODE_MASS,
                    AREA_DENSITY,
                    DAMPING,
                    DAMPING_RATE,
                    LUNG_STIFFNESS,
                    MEDIASTINUM_RIGHT,
                    MEDIASTINUM_LEFT -> TISSUE;
            case RATE,
                    DEPTH,
                    INSPIRATORY_FRACTION,
                    CHEST_SHARE,
                    REST_PRESSURE,
                    GREATEST_PRESSURE,
                    PRESSURE_LEFT_OVER_RIGHT -> BREATHING;
            case RIB_ROTATION,
                    UPPER_RIB_ROTATION,
                    LOWER_RIB_ROTATION,
                    RIB_LEFT_OVER_RIGHT,
                    BUCKET_HANDLE,
                    STERNUM_COUPLING -> RIBS;
        };
    }

    /** Whether a parameter has a part in how large a step may be. */
    static boolean limitsStep(Parameter parameter) {
        return switch (parameter) {
            case MUSCLE_STIFFNESS,
                    TENDON_RATIO,
                    SPRING_STIFFNESS,
                    NODE_MASS,
                    AREA_DENSITY,
                    STERNUM_COUPLING,
                    LUNG_STIFFNESS -> true;
            default -> false;
        };
    }
}
