package org.phrenic.ui.access;

import java.util.Optional;
import javax.swing.SwingUtilities;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.view.ViewedBody;

/** Looks at the side of a body on which needles go into the liver, once for each body. */
final class EntryView {
    private static final double AZIMUTH_DEG = -52;
    private static final double ELEVATION_DEG = 6;

    private final SceneViewport view;
    private Optional<ViewedBody> seen = Optional.empty();

    EntryView(SceneViewport view) {
        this.view = view;
    }

    void show(LiveScene scene) {
        ViewedBody body = ViewedBody.of(scene);
        if (seen.filter(body::isAlso).isEmpty()) {
            double[] bounds = body.bounds();
            // Runs after the view has taken over the scene, and its place in the window.
            SwingUtilities.invokeLater(() -> view.setCamera(camera(bounds, view.getWidth(), view.getHeight())
                    .withProjection(view.camera().orthographic())));
        }
        seen = Optional.of(body);
    }

    /** The camera that shows all of a body in a view of this size. */
    static Camera camera(double[] bounds, int width, int height) {
        double aspect = height > 0 ? (double) width / height : 1;
        return Camera.of(AnatomicalView.ANTERIOR, bounds, aspect)
                .orbit(AZIMUTH_DEG, ELEVATION_DEG)
                .fitting(bounds, aspect);
    }
}
