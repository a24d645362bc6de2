package org.phrenic.ui.view;

import java.util.Optional;
import org.phrenic.scene.AccessMapField;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.live.LiveScene;

/**
 * What the view should show.
 *
 * @param reference surface from which distances are measured
 * @param accessColours map that colours the skin
 * @param width of the frame, device pixels
 * @param height of the frame, device pixels
 * @param historyFrame recorded frame; -1 for the present
 */
record RenderRequest(
        LiveScene scene,
        Camera camera,
        SceneStyle style,
        Optional<DistanceField> reference,
        Optional<AccessMapField> accessColours,
        int width,
        int height,
        int historyFrame) {}
