package org.phrenic.study.stability;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.Stepper;

/** A scene of a stability case under one integrator, ready to be stepped. */
interface StabilityScene extends AutoCloseable {

    /** The clock of the scene. */
    Stepper stepper();

    /** Advances the scene by one time step, after what is changed in it on the way. */
    void step();

    /** Largest relative length error of the rigid links; 0 without links. */
    double linkError();

    /**
     * Undoes the change that made the scene diverge, if there is one.
     *
     * @return whether to continue
     */
    default boolean undoLastChange() {
        return false;
    }

    /** Stops what drives the scene, with as much damping as brings it to rest within {@link ThoraxScene#SETTLING_S}. */
    default void stopBreathing() {}

    default ParticleSystem system() {
        return stepper().system();
    }

    /** Ends the scene's threads. */
    @Override
    void close();
}
