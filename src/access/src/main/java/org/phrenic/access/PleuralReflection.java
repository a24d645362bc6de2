package org.phrenic.access;

import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;

/**
 * The line of pleural reflection on the diaphragm. The pleural recess, between rib cage and diaphragm where no lung
 * lies, ends where the parietal pleura turns from the wall to the diaphragm. No mesh shows that line; it is taken
 * {@value #HEIGHT_ABOVE_ORIGIN_MM} mm, about one rib, above the costal origin of the diaphragm, its lower rim: at rib
 * 10 in the mid-axillary line for an origin at rib 11 (textbook limits of the pleura: ribs 8, 10 and 12 in the
 * mid-clavicular, mid-axillary and paravertebral lines). A path that enters the diaphragm above it has crossed the
 * recess.
 */
public final class PleuralReflection {
    /** Height above the costal origin, mm. */
    public static final double HEIGHT_ABOVE_ORIGIN_MM = 20;

    private static final int SECTORS = 36;
    /** Vertices of the rim have at least this share of the largest radius; crura and tendon lie inside. */
    private static final double MIN_RIM_RADIUS = 0.75;

    private final double middleX;
    private final double middleY;
    private final double[] rim = new double[SECTORS];

    PleuralReflection(TriangleMesh diaphragm) {
        double[] box = diaphragm.bounds();
        middleX = 0.5 * (box[0] + box[3]);
        middleY = 0.5 * (box[1] + box[4]);
        int n = diaphragm.vertexCount();
        int[] sector = new int[n];
        double[] radius = new double[n];
        double[] farthest = new double[SECTORS];
        for (int i = 0; i < n; i++) {
            double x = diaphragm.x(i) - middleX;
            double y = diaphragm.y(i) - middleY;
            sector[i] = (int) sector(diaphragm.x(i), diaphragm.y(i)) % SECTORS;
            radius[i] = Math.sqrt(x * x + y * y);
            farthest[sector[i]] = Math.max(farthest[sector[i]], radius[i]);
        }
        Arrays.fill(rim, box[5]);
        for (int i = 0; i < n; i++) {
            if (radius[i] >= MIN_RIM_RADIUS * farthest[sector[i]]) {
                rim[sector[i]] = Math.min(rim[sector[i]], diaphragm.z(i));
            }
        }
    }

    private double sector(double x, double y) {
        double turn = StrictMath.atan2(y - middleY, x - middleX) / (2 * Math.PI);
        return (turn + 1) % 1 * SECTORS;
    }

    /** Whether a point of the diaphragm, given at rest, lies above the reflection. */
    public boolean isAbove(double restX, double restY, double restZ) {
        double at = sector(restX, restY) - 0.5 + SECTORS;
        int below = (int) at % SECTORS;
        double fraction = at - Math.floor(at);
        double height = (1 - fraction) * rim[below] + fraction * rim[(below + 1) % SECTORS];
        return restZ > height + HEIGHT_ABOVE_ORIGIN_MM;
    }
}
