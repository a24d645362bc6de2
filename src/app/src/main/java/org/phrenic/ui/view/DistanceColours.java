package org.phrenic.ui.view;

import org.phrenic.scene.DistanceField;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.observe.Frame;

/** Sends the distances of a structure from a surface to the renderer once for each step. Used on the render thread. */
final class DistanceColours {
    /** Identifies the distances that the renderer holds. */
    private record Key(long scene, long step, DistanceField from, String structure) {}

    private Key shown;

    void colour(Renderer renderer, long scene, Frame frame, DistanceField from, SceneStyle style) {
        String structure = style.colouring().structure();
        Key now = new Key(scene, frame.step(), from, structure);
        if (!now.equals(shown)) {
            from.upload(renderer, frame, structure);
            shown = now;
        }
    }
}
