package org.phrenic.simulation.live;

import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Frame;

/**
 * Sees a run at even intervals of simulated time, on the simulation's thread and between two steps: whatever the machine does, the same run is seen at the same steps. What it does is waited for, so it should be short.
 */
@FunctionalInterface
public interface Watch {
    /**
     * The scene as it stands.
     *
     * @param frame valid until it returns
     * @param label what the breath is doing
     */
    void see(Frame frame, BreathLabel label);
}
