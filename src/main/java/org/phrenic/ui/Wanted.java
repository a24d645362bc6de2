package org.phrenic.ui;

import java.util.Optional;
import org.phrenic.scene.AccessField;
import org.phrenic.scene.Camera;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.SceneStyle;
import org.phrenic.simulation.live.LiveScene;

/**
 * What the view should show.
 *
 * @param scene whose surfaces
 * @param camera from where
 * @param style how
 * @param distances what distances are measured from; empty for nothing
 * @param access map that colours the skin; empty for none
 * @param width of the picture, pixels of the device
 * @param height as above
 * @param scrubbed frame of the history; -1 for the present
 */
record Wanted(
        LiveScene scene,
        Camera camera,
        SceneStyle style,
        Optional<DistanceField> distances,
        Optional<AccessField> access,
        int width,
        int height,
        int scrubbed) {}
