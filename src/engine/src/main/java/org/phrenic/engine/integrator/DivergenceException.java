package org.phrenic.engine.integrator;

import java.util.Locale;

/**
 * Thrown after a simulation diverged and its last checkpoint was restored; the message is one sentence with the cause.
 */
public final class DivergenceException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    DivergenceException(double failedTime, double restoredTime, String cause) {
        super(String.format(Locale.ROOT, "the simulation diverged at %.4f s (%s);", failedTime, cause)
                + String.format(Locale.ROOT, " the state at %.4f s was restored", restoredTime));
    }
}
