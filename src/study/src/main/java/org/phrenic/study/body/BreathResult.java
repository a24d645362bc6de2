package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.file.Numbers;

/**
 * What one breath of a body gave.
 *
 * @param depth quiet or deep
 * @param failure why the breath ended early, one sentence; empty if it is complete
 * @param motion what moved; NaN if the breath is not complete
 * @param atRest organs through the diaphragm at rest
 * @param atInspiration the same at full inspiration; empty if the breath is not complete
 */
public record BreathResult(
        BreathDepth depth, String failure, Motion motion, OrganCrossing atRest, Optional<OrganCrossing> atInspiration) {
    /**
     * Motion of a breath.
     *
     * @param domeRightMm descent of the right dome from rest to full inspiration, mm
     * @param domeLeftMm the same of the left dome
     * @param airMl increase of lung volume, ml
     * @param returnRmsMm distance of all nodes from rest at the end of the breath, rms mm
     */
    public record Motion(double domeRightMm, double domeLeftMm, double airMl, double returnRmsMm) {
        static final Motion NONE = new Motion(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }

    static BreathResult failed(BreathDepth depth, String sentence, OrganCrossing atRest) {
        return new BreathResult(depth, sentence, Motion.NONE, atRest, Optional.empty());
    }

    /**
     * What is beyond the limits, one phrase each; empty if the breath is within all of them.
     *
     * @param height of the body relative to an adult's
     */
    public List<String> faults(double height) {
        if (!failure.isEmpty()) {
            return List.of(depth.preset() + ": " + failure);
        }
        List<String> faults = new ArrayList<>();
        if (!BodyLimits.isExcursion(depth, height, motion.domeRightMm())
                || !BodyLimits.isExcursion(depth, height, motion.domeLeftMm())) {
            faults.add(Numbers.format(
                    "%s: domes %.1f and %.1f mm", depth.preset(), motion.domeRightMm(), motion.domeLeftMm()));
        }
        if (!(motion.returnRmsMm() <= BodyLimits.RETURN_RMS_MM)) {
            faults.add(Numbers.format("%s: returns to %.2f mm rms", depth.preset(), motion.returnRmsMm()));
        }
        addThrough(atRest, "rest", faults);
        atInspiration.ifPresent(crossing -> addThrough(crossing, "full inspiration", faults));
        return faults;
    }

    private void addThrough(OrganCrossing crossing, String when, List<String> faults) {
        if (crossing.vertices() > 0) {
            faults.add(Numbers.format(
                    "%s: %d organ vertices through the diaphragm at %s, %s by %.1f mm",
                    depth.preset(), crossing.vertices(), when, crossing.deepest(), crossing.deepestMm()));
        }
    }
}
