package org.phrenic.parameter;

import java.util.Locale;
import org.phrenic.engine.integrator.IntegratorKind;

/** What the springs of the diaphragm stand for. */
public enum TissueMaterial {
    /**
     * A membrane under transdiaphragmatic pressure: stiffness, mass and damping a unit of area, muscle that shortens.
     */
    PHYSICAL(IntegratorKind.VERLET),
    /**
     * Villard, Bourne and Bello 2009: one stiffness for every spring, one mass for every node, muscle force along
     * action lines.
     */
    PAPER(IntegratorKind.STORMER);

    private final IntegratorKind integrator;

    TissueMaterial(IntegratorKind integrator) {
        this.integrator = integrator;
    }

    /**
     * Scheme where a scenario names none. The paper's springs move smoothly on the scale of a step, so that Störmer's
     * formula errs by a fifth of what Verlet does; contact and order of the faces in the physical material do not.
     */
    public IntegratorKind integrator() {
        return integrator;
    }

    /** Name in scenario files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
