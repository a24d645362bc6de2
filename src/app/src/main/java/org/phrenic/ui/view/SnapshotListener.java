package org.phrenic.ui.view;

import java.awt.image.BufferedImage;
import java.util.Optional;
import org.phrenic.scene.NeedleMarkers;

/** Gets a picture of the frame that is shown, with its time and its needle. */
interface SnapshotListener {
    void drawn(BufferedImage image, String timeText, Optional<NeedleMarkers> marks);
}
