package org.phrenic.simulation.live;

import java.util.List;
import java.util.function.Supplier;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Overlay;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Surface;

public record LiveScene(Scenario scenario, List<Surface> surfaces, List<Overlay> overlays, Supplier<Frame> newFrame, int nodes, int springs, List<String> notes, long id) {}
