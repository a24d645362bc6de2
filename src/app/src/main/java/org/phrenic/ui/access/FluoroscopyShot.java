package org.phrenic.ui.access;

import java.awt.image.BufferedImage;
import org.phrenic.access.imaging.CArm;
import org.phrenic.access.imaging.Radiograph;
import org.phrenic.access.plan.NeedleState;

/**
 * A picture of the X-ray view.
 *
 * @param arm how it was taken
 * @param picture its grey levels
 * @param state needle and target at its moment
 */
public record FluoroscopyShot(CArm arm, BufferedImage picture, NeedleState state) {
    /** @param range attenuations that are black and white */
    static FluoroscopyShot of(Radiograph radiograph, double[] range, NeedleState state) {
        CArm arm = radiograph.arm();
        BufferedImage picture = new BufferedImage(arm.columns(), arm.rows(), BufferedImage.TYPE_BYTE_GRAY);
        picture.getRaster().setDataElements(0, 0, arm.columns(), arm.rows(), radiograph.grey(range[0], range[1]));
        return new FluoroscopyShot(arm, picture, state);
    }
}
