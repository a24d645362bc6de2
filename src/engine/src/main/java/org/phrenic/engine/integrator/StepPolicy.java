package org.phrenic.engine.integrator;

/** What to do with a time step beyond the stability limit. */
public enum StepPolicy {
    /** Split it into equal substeps. */
    SUBSTEP,
    /** Refuse it with an exception that states the step and the limit. */
    REFUSE
}
