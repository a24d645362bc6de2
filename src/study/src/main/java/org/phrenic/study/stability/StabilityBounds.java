package org.phrenic.study.stability;

import java.util.EnumMap;
import java.util.Map;

/**
 * What must hold in a stability case.
 *
 * @param maxima largest value allowed of each measure; what is missing is not bounded
 * @param shapeUntilS until when {@link StabilityMeasure#SHAPE} is compared, s: where a sheet crumples or snaps through,
 *     reference solutions of different fineness part too
 */
record StabilityBounds(Map<StabilityMeasure, Double> maxima, double shapeUntilS) {
    /**
     * A cough moves tissue at some 1,000 mm/s and nothing in a trunk is 300 mm from where it was; links to a
     * thousandth.
     */
    static final StabilityBounds BODY = new StabilityBounds(
            Map.of(
                    StabilityMeasure.SPEED_MM_S, 1000.0,
                    StabilityMeasure.REACH_MM, 300.0,
                    StabilityMeasure.LINK_ERROR, 1e-3),
            Double.POSITIVE_INFINITY);

    /** These bounds with another maximum; infinity for no bound. */
    StabilityBounds with(StabilityMeasure measure, double maximum) {
        Map<StabilityMeasure, Double> changed = new EnumMap<>(maxima);
        changed.put(measure, maximum);
        return new StabilityBounds(changed, shapeUntilS);
    }

    StabilityBounds withShapeUntil(double seconds) {
        return new StabilityBounds(maxima, seconds);
    }

    /** Infinity where the measure is not bounded. */
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
