package org.phrenic.patient;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * Size of a scanned body relative to a template, from side to side, from back to front and along the body. Sizes and
 * proportions that people do not have mean a wrong spacing or unit. Three pairs of lungs, two sets of lungs and ribs, a
 * whole thorax and two abdominal scans have 0.85 to 1.28 along each direction, the largest at most 1.33 times the
 * smallest.
 */
public final class BodyPlausibility {
    /** Limits of the geometric mean. */
    private static final double MIN_SIZE = 0.5;

    private static final double MAX_SIZE = 1.7;
    /** Ratio of the largest to the smallest factor beyond which a body gets a note, and beyond which it is refused. */
    private static final double NOTED_RATIO = 1.5;

    private static final double MAX_RATIO = 1.75;

    private final double[] factors;
    private final String template;
    private final String hint;

    /**
     * @param factors from side to side, from back to front and along the body
     * @param ofVoxels whether the body comes from a volume, whose spacing may be wrong, not from meshes
     */
    public BodyPlausibility(double[] factors, String template, boolean ofVoxels) {
        this.factors = factors.clone();
        this.template = template;
        hint = ofVoxels
                ? "is the spacing right? see --spacing"
                : "are units and axes right? a thorax.yaml beside the meshes states them";
    }

    /** @throws BadInputException without the file's name, if people are not of that size */
    public void require() {
        double size = StrictMath.cbrt(factors[0] * factors[1] * factors[2]);
        if (!(size >= MIN_SIZE && size <= MAX_SIZE)) {
            throw new BadInputException(Numbers.format(
                    "found a body %.3f times as large as %s, expected %.1f to %.1f times; %s",
                    size, template, MIN_SIZE, MAX_SIZE, hint));
        }
        if (ratio() > MAX_RATIO) {
            throw new BadInputException("found " + sentence());
        }
    }

    /** A note on proportions that people hardly have. */
    public Optional<String> note() {
        return ratio() <= NOTED_RATIO ? Optional.empty() : Optional.of(sentence());
    }

    private double ratio() {
        double[] sorted = factors.clone();
        Arrays.sort(sorted);
        return sorted[2] / sorted[0];
    }

    private String sentence() {
        return Numbers.format(
                "a body %.2f times as wide, %.2f times as deep and %.2f times as tall as %s, expected more even"
                        + " proportions; %s",
                factors[0], factors[1], factors[2], template, hint);
    }
}
