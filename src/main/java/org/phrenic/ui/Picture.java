package org.phrenic.ui;

import java.awt.image.BufferedImage;
import java.util.Optional;
import org.phrenic.scene.FrameCost;
import org.phrenic.scene.NeedleMarks;

/**
 * A picture of the scene and what it was made of.
 *
 * @param image pixels
 * @param wanted what was asked for
 * @param step of the simulation that is shown
 * @param moment time and place in the breath
 * @param marks needle and target in it
 * @param cost of drawing it
 */
record Picture(
        BufferedImage image, Wanted wanted, long step, String moment, Optional<NeedleMarks> marks, FrameCost cost) {}
