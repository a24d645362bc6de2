package org.phrenic.scene;

import java.util.*;
import org.phrenic.simulation.Overlay;
import org.phrenic.simulation.Surface;

public record SceneStyle(Map<String, Look> looks, Background background, boolean restWireframe, ColourField field, String fieldStructure, ColourScale scale, Set<Overlay.Kind> overlays, Optional<ClipPlane> clip, Transparency transparency, int samples, String highlighted) {
    public record Look(boolean visible, float[] rgb, float opacity, boolean wireframe) {}
    public enum Background {LIGHT, DARK}
    public enum Transparency {TWO_PASS, PEELED}
    public enum ColourField {NONE, DISPLACEMENT, STRAIN, DISTANCE}
    public record ClipPlane(double nx, double ny, double nz, double offset) {}
    public static SceneStyle atlas(List<Surface> surfaces) {
        Map<String, Look> looks = new LinkedHashMap<>();
        surfaces.forEach(s -> looks.put(s.name(), new Look(true, new float[] {.8f, .7f, .6f}, 1, false)));
        return new SceneStyle(looks, Background.LIGHT, false, ColourField.NONE, "", ColourScale.magnitude(20, "mm"), Set.of(), Optional.empty(), Transparency.TWO_PASS, 1, "");
    }
}
