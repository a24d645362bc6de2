package org.phrenic.simulation.live;

import java.util.List;
import java.util.function.Supplier;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * Display data of a running scene; thread-safe.
 *
 * @param scenario at the start
 * @param surfaces in the order in which a {@link Frame} holds them
 * @param overlays that can be drawn over the surfaces
 * @param newFrame creates a matching frame that holds the scene at rest; callable on any thread
 * @param nodes number of nodes
 * @param springs number of springs
 * @param body the body as loaded, with its notes
 * @param id unique among loaded scenes
 */
public record LiveScene(
        Scenario scenario,
        List<Surface> surfaces,
        List<Overlay> overlays,
        Supplier<Frame> newFrame,
        int nodes,
        int springs,
        Thorax body,
        long id) {}
