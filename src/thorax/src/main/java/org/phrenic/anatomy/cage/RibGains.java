package org.phrenic.anatomy.cage;

import org.phrenic.anatomy.Side;

/**
 * Factors on the rotation of ribs by level and side: {@code (1 + u (upper - 1) + l (lower - 1)) w}. Weight u is 1 for
 * ribs 1 to 3 and falls to 0 at rib 6; l rises from 0 at rib 6 to 1 for ribs 9 to 12; both change by thirds. Weight w
 * is 1 on the side with the larger rotation and the ratio of the sides on the other. The sternum has the mean factor of
 * ribs 1 to 7. Rates are time derivatives, 1/s.
 */
public final class RibGains {
    private static final int MIDDLE = 6;
    private static final double LEVELS = 3;
    private static final int LAST_TRUE_RIB = 7;

    private final RibCage cage;
    private double upper = 1;
    private double lower = 1;
    private double sideRatio = 1;
    private double upperRate;
    private double lowerRate;
    private double sidesRate;
    private double bucket = 1;

    RibGains(RibCage cage) {
        this.cage = cage;
    }

    /**
     * Sets the factors.
     *
     * @param upperRibs factor of the upper ribs
     * @param lowerRibs factor of the lower ribs
     * @param leftOverRight ratio of left to right rotation, above 0
     */
    public void setFactors(double upperRibs, double lowerRibs, double leftOverRight) {
        upper = upperRibs;
        lower = lowerRibs;
        sideRatio = leftOverRight;
    }

    /** Sets the time derivatives of the factors, 1/s. */
    public void setRates(double upperRibs, double lowerRibs, double leftOverRight) {
        upperRate = upperRibs;
        lowerRate = lowerRibs;
        sidesRate = leftOverRight;
    }

    /** Sets the factor on the bucket-handle component of each rib's rotation ({@link RibCage#motions}). */
    public void setBucket(double factor) {
        bucket = factor;
    }

    double bucket() {
        return bucket;
    }

    /** Factor of a body. */
    double factorOf(int body) {
        return body == cage.sternum()
                ? meanOfTrueRibs(false)
                : ribFactor(cage.bodies().get(body), false);
    }

    /** Time derivative of the factor of a body, 1/s. */
    double factorRateOf(int body) {
        return body == cage.sternum()
                ? meanOfTrueRibs(true)
                : ribFactor(cage.bodies().get(body), true);
    }

    private double meanOfTrueRibs(boolean rate) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < cage.bodies().size(); i++) {
            RibCage.Body body = cage.bodies().get(i);
            if (body.level() >= 1 && body.level() <= LAST_TRUE_RIB) {
                sum += ribFactor(body, rate);
                count++;
            }
        }
        return sum / count;
    }

    private double ribFactor(RibCage.Body body, boolean rate) {
        double u = Math.max(0, Math.min(1, (MIDDLE - body.level()) / LEVELS));
        double l = Math.max(0, Math.min(1, (body.level() - MIDDLE) / LEVELS));
        double group = 1 + u * (upper - 1) + l * (lower - 1);
        boolean left = body.side() == Side.LEFT;
        boolean weaker = left == sideRatio < 1;
        double share = !weaker ? 1 : left ? sideRatio : 1 / sideRatio;
        if (!rate) {
            return group * share;
        }
        double shareRate = !weaker ? 0 : left ? sidesRate : -sidesRate / (sideRatio * sideRatio);
        return (u * upperRate + l * lowerRate) * share + group * shareRate;
    }
}
