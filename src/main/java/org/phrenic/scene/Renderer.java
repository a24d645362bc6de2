package org.phrenic.scene;
import java.util.List;
import org.phrenic.simulation.*;
public final class Renderer { public Renderer(List<Surface> s, List<Overlay> o) {} }
