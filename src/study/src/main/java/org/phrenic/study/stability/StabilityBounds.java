package org.phrenic.study.stability;

import java.util.EnumMap;
import java.util.Map;

/**
 * Bounds of a stability case.
 *
 * @param maxima largest allowed value by measure; missing measures are unbounded
 * @param shapeUntilS end of the comparison of {@link StabilityMeasure#SHAPE}, s. After a sheet crumples or snaps
 *     through, reference solutions with different time steps diverge from each other as well.
 * @param impossible whether the settings contradict each other, which is to be noticed
 */
record StabilityBounds(Map<StabilityMeasure, Double> maxima, double shapeUntilS, boolean impossible) {
    /**
     * Bounds of a body: tissue speed in a cough is about 1,000 mm/s, no displacement in a trunk reaches 300 mm, and
     * links hold to a thousandth.
     */
    static final StabilityBounds BODY = new StabilityBounds(
            Map.of(
                    StabilityMeasure.SPEED_MM_S, 1000.0,
                    StabilityMeasure.REACH_MM, 300.0,
                    StabilityMeasure.LINK_ERROR, 1e-3),
            Double.POSITIVE_INFINITY,
            false);

    /** A copy with another maximum; infinity for no bound. */
    StabilityBounds with(StabilityMeasure measure, double maximum) {
        Map<StabilityMeasure, Double> changed = new EnumMap<>(maxima);
        changed.put(measure, maximum);
        return new StabilityBounds(changed, shapeUntilS, impossible);
    }

    StabilityBounds withShapeUntil(double seconds) {
        return new StabilityBounds(maxima, seconds, impossible);
    }

    /** The bounds of settings that contradict each other. */
    StabilityBounds ofImpossible() {
        return new StabilityBounds(maxima, shapeUntilS, true);
    }

    /** Maximum of a measure; infinity if unbounded. */
    double maximum(StabilityMeasure measure) {
        return maxima.getOrDefault(measure, Double.POSITIVE_INFINITY);
    }

    boolean isBounded(StabilityMeasure measure) {
        return maximum(measure) < Double.POSITIVE_INFINITY;
    }

    boolean needsReference() {
        return isBounded(StabilityMeasure.KINETIC_FACTOR) || isBounded(StabilityMeasure.SHAPE);
    }
}
