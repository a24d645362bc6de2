package org.phrenic.simulation.assembly;

import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.scenario.Scenario;

/**
 * What of a running simulation can be turned smoothly: each has a value for every scenario, 0 where its switch is off.
 */
enum Knob {
    /** Membrane stiffness of muscle, or the paper's one stiffness. */
    STIFFNESS(true),
    TENDON_RATIO(true),
    LUNG_STIFFNESS(true),
    /** Mass per area, or the paper's one mass. */
    MASS(true),
    DAMPING(true),
    COUPLING(true),
    LEFT_OVER_RIGHT(true),
    FRONT_OVER_BACK(true),
    REST_PRESSURE(true),
    LINE_RADIUS(false),
    ACTIVATION(false),
    LINE_FORCE(false),
    EFFORT_PRESSURE(false),
    PRESSURE_SIDES(false),
    RIB_ROTATION(false),
    UPPER_RIBS(false),
    LOWER_RIBS(false),
    RIB_SIDES(false),
    BUCKET(false),
    MEDIASTINUM_RIGHT(false),
    MEDIASTINUM_LEFT(false),
    /** Rigid links at their given length (1) or as long as they were found (0). */
    LINKS(false),
    /** The wall as hard as it gets (1) or not there (0). */
    CONTACT(false);

    private final boolean affectsTissue;

    Knob(boolean material) {
        this.affectsTissue = material;
    }

    /** Whether it changes springs, masses or damping, and so may change the stability limit. */
    boolean affectsTissue() {
        return affectsTissue;
    }

    /** Its place in an array of one value a knob. */
    @SuppressWarnings("EnumOrdinal") // arrays of one value a knob live no longer than a run: the order may change
    int index() {
        return ordinal();
    }

    /** Its value in a scenario; NaN where the material has no use for it. */
    double valueIn(Scenario s) {
        boolean physical = s.material() == TissueMaterial.PHYSICAL;
        return switch (this) {
            case STIFFNESS -> s.value(physical ? Parameter.MUSCLE_STIFFNESS : Parameter.SPRING_STIFFNESS);
            case TENDON_RATIO -> s.value(Parameter.TENDON_RATIO);
            case LUNG_STIFFNESS -> s.value(Parameter.LUNG_STIFFNESS);
            case MASS -> s.value(physical ? Parameter.AREA_DENSITY : Parameter.NODE_MASS);
            case DAMPING -> s.value(physical ? Parameter.DAMPING_RATE : Parameter.DAMPING);
            case COUPLING -> s.value(Parameter.STERNUM_COUPLING);
            case LEFT_OVER_RIGHT -> physical ? s.value(Parameter.LEFT_OVER_RIGHT) : 1;
            case FRONT_OVER_BACK -> physical ? s.value(Parameter.FRONT_OVER_BACK) : 1;
            case REST_PRESSURE -> s.pressure() ? s.value(Parameter.REST_PRESSURE) : 0;
            case LINE_RADIUS -> s.value(Parameter.ACTION_RADIUS);
            case ACTIVATION -> s.muscle() ? s.value(Parameter.MUSCLE_ACTIVATION) : 0;
            case LINE_FORCE -> s.muscle() ? s.value(Parameter.MUSCLE_FORCE) : 0;
            case EFFORT_PRESSURE -> s.pressure() ? s.value(Parameter.GREATEST_PRESSURE) : 0;
            case PRESSURE_SIDES -> physical ? s.value(Parameter.PRESSURE_LEFT_OVER_RIGHT) : 1;
            case UPPER_RIBS -> s.value(Parameter.UPPER_RIB_ROTATION);
            case LOWER_RIBS -> s.value(Parameter.LOWER_RIB_ROTATION);
            case RIB_SIDES -> s.value(Parameter.RIB_LEFT_OVER_RIGHT);
            case BUCKET -> s.value(Parameter.BUCKET_HANDLE);
            case MEDIASTINUM_RIGHT -> physical ? s.value(Parameter.MEDIASTINUM_RIGHT) : 0;
            case MEDIASTINUM_LEFT -> physical ? s.value(Parameter.MEDIASTINUM_LEFT) : 0;
            case RIB_ROTATION -> s.ribs() ? s.value(Parameter.RIB_ROTATION) : 0;
            case LINKS -> s.tensegrity() ? 1 : 0;
            case CONTACT -> s.contact() ? 1 : 0;
        };
    }
}
