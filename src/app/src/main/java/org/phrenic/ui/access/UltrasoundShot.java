package org.phrenic.ui.access;

import java.awt.image.BufferedImage;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.ultrasound.BModeImage;

/**
 * A live ultrasound image.
 *
 * @param image the image
 * @param picture its grey levels
 * @param state needle and probe at its moment
 */
public record UltrasoundShot(BModeImage image, BufferedImage picture, NeedleState state) {
    /** With the picture of an image. */
    static UltrasoundShot of(BModeImage image, NeedleState state) {
        int size = BModeImage.SIZE;
        BufferedImage picture = new BufferedImage(size, size, BufferedImage.TYPE_BYTE_GRAY);
        picture.getRaster().setDataElements(0, 0, size, size, image.grey());
        return new UltrasoundShot(image, picture, state);
    }
}
