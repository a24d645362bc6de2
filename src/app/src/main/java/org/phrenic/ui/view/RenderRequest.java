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
 * @param scene whose surfaces
 * @param camera from where
 * @param style how
 * @param reference what distances are measured from; empty for nothing
 * @param accessColours map that colours the skin; empty for none
 * @param width of the picture, pixels of the device
 * @param height as above
 * @param historyFrame frame of the history; -1 for the present
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
