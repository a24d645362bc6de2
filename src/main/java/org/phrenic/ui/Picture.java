package org.phrenic.ui;

import java.awt.image.BufferedImage;

/**
 * A picture of the scene and what it was made of.
 *
 * @param image pixels
 * @param wanted what was asked for
 * @param step of the simulation that is shown
 * @param moment time and place in the breath
 */
record Picture(BufferedImage image, Wanted wanted, long step, String moment) {}
