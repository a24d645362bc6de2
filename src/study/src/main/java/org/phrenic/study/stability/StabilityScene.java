package org.phrenic.study.stability;

import java.util.Map;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.Stepper;

/** Scene of a stability case under one integrator. */
interface StabilityScene extends AutoCloseable {

    /** The stepper of the scene. */
    Stepper stepper();

    /** Applies pending changes, then advances the scene by one time step. */
    void step();

    /** Largest relative length error of the rigid links; 0 without links. */
    double linkError();

    /**
     * How far contacts are violated, measured anew from positions and wall and independent of the constraints that act
     * in the scene; empty without contacts.
     */
    default Map<StabilityMeasure, Double> contactErrors() {
        return Map.of();
    }

    /**
     * Undoes the change that caused a divergence, if there is one.
     *
     * @return whether to continue
     */
    default boolean undoLastChange() {
        return false;
    }

    /** Stops the drive and raises damping so that the scene comes to rest within {@link ThoraxScene#SETTLING_S}. */
    default void stopBreathing() {}

    default ParticleSystem system() {
        return stepper().system();
    }

    /** Stops the scene's threads. */
    @Override
    void close();
}
