package org.phrenic.access.plan;

import java.util.Optional;
import org.phrenic.access.ultrasound.BModeImage;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.SonatedNeedle;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.simulation.observe.Frame;

/**
 * All that an ultrasound image of a rehearsal is made of besides the positions of the body.
 *
 * @param pose where the probe is
 * @param needle the needle on or in the body; empty for none
 * @param target centre of the target, LPS, mm
 */
public record ImageMoment(
        ProbePose pose, UltrasoundSettings settings, Optional<SonatedNeedle> needle, double[] target) {
    /**
     * Takes the image.
     *
     * @param ultrasound of the body, with the target as its lesion
     * @param frame positions of the body at the same moment
     */
    public BModeImage take(Ultrasound ultrasound, Frame frame) {
        return ultrasound.take(frame, pose, settings, needle, Optional.of(target));
    }
}
