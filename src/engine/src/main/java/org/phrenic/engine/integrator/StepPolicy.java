package org.phrenic.engine.integrator;

/** What to do with a time step beyond the stability limit. */
public enum StepPolicy {
    /** Split it into equal substeps. */
    SUBSTEP,
    /** Refuse it with an exception that states the step and the limit. */
    REFUSE;

    /** Maximum number of substeps a step. With more, the program would appear to hang. */
    static final int MAX_SUBSTEPS = 10_000;

    /** Number of substeps of a step under a limit; throws if the step is refused. */
    int substeps(IntegratorKind kind, double step, StabilityLimit measured) {
        boolean apart = measured.apart()
                .map(limitApart -> limitApart.isStable(kind, step))
                .orElse(true);
        if (this == REFUSE && !(apart && measured.isStable(kind, step))) {
            StabilityLimit exceeded = apart ? measured : measured.apart().orElseThrow();
            throw new IllegalArgumentException(exceeded.describe(kind, step) + ": refused");
        }
        int parts = this == REFUSE ? 1 : measured.substeps(kind, step, Stepper.SAFETY);
        return requireFew(parts, kind, step, measured);
    }

    /** Number of steps of nodes apart in a substep of the others. */
    int stepsApart(IntegratorKind kind, double h, StabilityLimit measured) {
        int parts = this == REFUSE ? 1 : measured.stepsApart(kind, h, Stepper.SAFETY);
        return requireFew(parts, kind, h, measured.apart().orElse(measured));
    }

    private static int requireFew(int parts, IntegratorKind kind, double step, StabilityLimit measured) {
        if (parts > MAX_SUBSTEPS) {
            throw new IllegalArgumentException(measured.describe(kind, step) + ": it would take " + parts
                    + " substeps, expected at most " + MAX_SUBSTEPS
                    + " (choose verlet or backward-euler, or a shorter time step)");
        }
        return parts;
    }
}
