package org.phrenic.simulation.live;

import java.util.List;
import java.util.function.Supplier;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * What there is to draw of a scene that runs; safe to share between threads.
 *
 * @param scenario as it was started
 * @param surfaces in the order in which a {@link Frame} holds them
 * @param overlays what can be drawn over them
 * @param newFrame makes a frame that fits, holding the scene at rest; may be called on any thread
 * @param nodes how many
 * @param springs how many
 * @param notes what is worth saying of the body, a sentence each
 * @param id another one for every scene that is loaded
 */
public record LiveScene(
        Scenario scenario,
        List<Surface> surfaces,
        List<Overlay> overlays,
        Supplier<Frame> newFrame,
        int nodes,
        int springs,
        List<String> notes,
        long id) {}
