package org.phrenic.study.stability;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.Stepper;

/** One hard scene under one integrator, ready to be stepped. */
interface StabilityScene extends AutoCloseable {

    /** The clock of the scene. */
    Stepper stepper();

    /** Carries the scene over one time step, after whatever is done to it on the way. */
    void step();

    /** Largest relative length error of the rigid links; 0 without links. */
    double linkError();

    /**
     * Takes back what made the scene diverge, where there is something to take back.
     *
     * @return whether to go on
     */
    default boolean undoLastChange() {
        return false;
    }

    /** Stops what drives the scene, with as much damping as brings it to rest within {@link BreathStop#SETTLING_S}. */
    default void stopBreathing() {}

    default ParticleSystem system() {
        return stepper().system();
    }

    /** Ends the scene's threads. */
    @Override
    void close();
}
