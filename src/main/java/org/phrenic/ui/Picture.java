package org.phrenic.ui;

import java.awt.image.BufferedImage;
import org.phrenic.scene.FrameCost;

/**
 * A picture of the scene and what it was made of.
 *
 * @param image pixels
 * @param wanted what was asked for
 * @param step of the simulation that is shown
 * @param moment time and place in the breath
 * @param cost of drawing it
 */
record Picture(BufferedImage image, Wanted wanted, long step, String moment, FrameCost cost) {}
