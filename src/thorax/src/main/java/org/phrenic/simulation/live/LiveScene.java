package org.phrenic.simulation.live;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
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
 * @param body the body as loaded, with its notes
 * @param id unique in a run: its scenes count from 1 up, bodies at rest from -1 down
 */
public record LiveScene(
        Scenario scenario,
        List<Surface> surfaces,
        List<Overlay> overlays,
        Supplier<Frame> newFrame,
        int nodes,
        Thorax body,
        long id) {
    private static final AtomicLong BODIES_AT_REST = new AtomicLong();

    /** A body at rest, all of whose surfaces stand still, to be shown while its scene is assembled. */
    public static LiveScene atRest(Scenario scenario, Thorax body) {
        List<Surface> surfaces = body.structures().stream()
                .map(s -> new Surface(
                        s.name(), s.kind(), s.level(), s.side(), s.mesh(), Surface.Motion.STILL, new boolean[0]))
                .toList();
        return new LiveScene(
                scenario, surfaces, List.of(), () -> Frame.still(surfaces), 0, body, BODIES_AT_REST.decrementAndGet());
    }

    /** Whether this is a body that is shown before its scene runs. */
    public boolean isAtRest() {
        return id < 0;
    }
}
