package org.phrenic.ui.view;

import java.awt.image.BufferedImage;
import java.util.Optional;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.scene.gl.FrameStatistics;

/**
 * A drawn frame.
 *
 * @param step simulation step that is shown
 * @param timeText time and phase of the breath
 * @param needleMarks needle and target in it
 * @param cost of drawing it
 * @param resolution drawn over shown pixels along each side
 */
public record RenderedFrame(
        BufferedImage image,
        RenderLoop.Request request,
        long step,
        String timeText,
        Optional<NeedleMarkers> needleMarks,
        FrameStatistics cost,
        double resolution) {}
