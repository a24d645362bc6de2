package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.phrenic.anatomy.Side;

/**
 * The line of insertion as a height over the azimuth about the cage's axis, through the {@link InsertionSites}: back of
 * the xiphoid, lower border of the costal margin, tips of ribs 11 and 12, transverse process of L1 (arcuate ligaments),
 * and the crura in front of L1 to L3 on the right and L1 to L2 on the left. The line is smoothed over
 * {@value #SMOOTHING_DEG} degrees.
 */
final class InsertionLine {
    private static final int SECTORS = 360;
    /** Depth of the insertion below the lowest vertex of the costal margin at an azimuth, mm. */
    private static final double BELOW_MARGIN_MM = 0;

    private static final double CRUS_RAD = Math.toRadians(8);
    private static final double SMOOTHING_DEG = 4;
    private static final double MIDLINE_RAD = 0.05;

    /** Height at each degree of azimuth, from -180 degrees on, and once more at 180 degrees. */
    private final double[] height = new double[SECTORS + 1];

    /** @param ceiling greatest height, mm; a diaphragm does not insert above its domes, however flat they are */
    InsertionLine(InsertionSites sites, double ceiling) {
        List<double[]> corners = new ArrayList<>();
        sites.xiphoid().ifPresent(z -> {
            corners.add(new double[] {-Math.PI, z + InsertionSites.ABOVE_XIPHOID_MM});
            corners.add(new double[] {Math.PI, z + InsertionSites.ABOVE_XIPHOID_MM});
        });
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            for (double[] corner : corners(sites, side)) {
                corners.add(new double[] {(side == Side.LEFT ? 1 : -1) * corner[0], corner[1]});
            }
        }
        corners.sort(Comparator.comparingDouble(c -> c[0]));
        double[] raw = new double[SECTORS + 1];
        for (int i = 0; i <= SECTORS; i++) {
            raw[i] = Math.min(ceiling, between(corners, Math.toRadians(i - 180.0)));
        }
        smooth(raw);
    }

    /** Azimuths from the back, increasing, and heights of one side. */
    private static List<double[]> corners(InsertionSites sites, Side side) {
        List<double[]> corners = new ArrayList<>();
        sites.front(side == Side.LEFT ? 2 : 3, side)
                .or(() -> sites.front(1, side))
                .ifPresent(f -> corners.add(new double[] {CRUS_RAD, f.middle()}));
        List<double[]> margin = sites.margin(side);
        for (double[] c : sites.lateral(side, margin)) {
            if (corners.isEmpty() || c[0] > corners.get(corners.size() - 1)[0]) {
                corners.add(c);
            }
        }
        double end = corners.isEmpty() ? 0 : corners.get(corners.size() - 1)[0];
        for (double[] p : margin) {
            double a = sites.azimuth(p, side);
            if (a > end && a < Math.PI - MIDLINE_RAD) {
                corners.add(new double[] {a, p[2] - BELOW_MARGIN_MM});
            }
        }
        return corners;
    }

    /** Gaussian smoothing over the azimuth. */
    private void smooth(double[] raw) {
        int reach = (int) Math.ceil(3 * SMOOTHING_DEG);
        for (int i = 0; i <= SECTORS; i++) {
            double sum = 0;
            double total = 0;
            for (int k = -reach; k <= reach; k++) {
                double weight = StrictMath.exp(-0.5 * k * k / (SMOOTHING_DEG * SMOOTHING_DEG));
                sum += weight * raw[Math.floorMod(i + k, SECTORS)];
                total += weight;
            }
            height[i] = sum / total;
        }
    }

    private static double between(List<double[]> corners, double at) {
        int high = 1;
        while (high < corners.size() - 1 && corners.get(high)[0] < at) {
            high++;
        }
        double[] a = corners.get(high - 1);
        double[] b = corners.get(high);
        double t = Math.max(0, Math.min(1, (at - a[0]) / Math.max(1e-9, b[0] - a[0])));
        return a[1] + t * (b[1] - a[1]);
    }

    /** Height of the insertion at an azimuth, -pi to pi, mm. */
    double height(double azimuth) {
        double at = Math.max(0, Math.min(SECTORS, Math.toDegrees(azimuth) + 180));
        int i = Math.min(SECTORS - 1, (int) at);
        return height[i] + (at - i) * (height[i + 1] - height[i]);
    }
}
