package org.phrenic.access;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Map;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.Vectors;

/**
 * A straight, rigid biopsy needle.
 *
 * @param gauge Birmingham (Stubs) gauge
 * @param lengthMm distance from hub to tip, mm
 * @param coreMm length of the core that a core needle cuts when it fires, from the tip on, mm; 0 for a needle that
 *     takes its sample at the tip
 */
public record Needle(int gauge, double lengthMm, double coreMm) {
    /** Least depth that a needle is aimed at, mm. */
    public static final double LEAST_AIM_MM = 1;

    /** Outer diameter of needle tubing by gauge, mm (ISO 9626 nominal sizes). */
    private static final Map<Integer, Double> DIAMETER_MM =
            Map.of(14, 2.1, 15, 1.8, 16, 1.6, 17, 1.4, 18, 1.2, 19, 1.1, 20, 0.9, 21, 0.8, 22, 0.7);

    /** Places along the needle are known to this, mm. */
    private static final double ROUNDING_MM = 1e-9;

    /** Significant digits that a number has at most. */
    private static final int ALL_DIGITS = 17;

    private static final double MIN_LENGTH_MM = 20;
    private static final double MAX_LENGTH_MM = 300;

    /** Usual throws of core needles, mm. */
    private static final double MIN_CORE_MM = 10;

    private static final double MAX_CORE_MM = 22;

    /** A needle that takes its sample at the tip. */
    public Needle(int gauge, double lengthMm) {
        this(gauge, lengthMm, 0);
    }

    /** @throws IllegalArgumentException if the gauge, core or length is outside the range of biopsy needles */
    public Needle {
        if (!DIAMETER_MM.containsKey(gauge)) {
            throw new IllegalArgumentException("found a needle of " + gauge + " G, expected 14 to 22 G");
        }
        if (!isCore(coreMm)) {
            throw new IllegalArgumentException("found a core of " + coreMm + " mm, expected 0 for none or "
                    + MIN_CORE_MM + " to " + MAX_CORE_MM + " mm");
        }
        if (!(lengthMm >= MIN_LENGTH_MM && lengthMm <= MAX_LENGTH_MM)) {
            throw new IllegalArgumentException("found a needle " + lengthMm + " mm long, expected " + MIN_LENGTH_MM
                    + " to " + MAX_LENGTH_MM + " mm");
        }
    }

    /** Whether a path of some length, mm, is too long for the needle, by more than rounding makes of its own length. */
    public boolean isShorterThan(double pathMm) {
        return !(pathMm <= lengthMm + ROUNDING_MM);
    }

    private static boolean isCore(double mm) {
        return mm == 0 || (mm >= MIN_CORE_MM && mm <= MAX_CORE_MM);
    }

    /** The usual needle for focal lesions: 18 G, 150 mm. */
    public static Needle standard() {
        return new Needle(18, 150);
    }

    /** The length as text, in full: what is said to be longer is stated longer. */
    public String length() {
        return Numbers.trimmed(lengthMm, ALL_DIGITS) + " mm";
    }

    /** A path in mm with one decimal, not below it: one beyond the needle is stated beyond it. */
    private static String upward(double pathMm) {
        return Double.isFinite(pathMm)
                ? BigDecimal.valueOf(pathMm).setScale(1, RoundingMode.CEILING).toPlainString()
                : Double.toString(pathMm);
    }

    /** Outer radius, mm. */
    public double radiusMm() {
        return 0.5 * DIAMETER_MM.get(gauge);
    }

    /**
     * Checks that the needle is long enough to reach from {@code from} to {@code aim}.
     *
     * @throws BadInputException if the needle is too short or the points are less than 1 mm apart
     */
    public void requireReach(double[] from, double[] aim) {
        double path = Vectors.distance(from, aim);
        if (isShorterThan(path)) {
            throw new BadInputException("needle: found " + length() + " for a path of " + upward(path)
                    + " mm, expected a longer needle or a nearer entry");
        }
        if (path < 1) {
            throw new BadInputException(
                    "aim: found a place less than 1 mm from the entry, expected one within the body");
        }
    }
}
