package org.phrenic.access;

import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;

/**
 * The line of pleural reflection on the diaphragm. The pleural recess is the space between rib cage and diaphragm that
 * the lung does not fill. It ends where the parietal pleura turns from the chest wall to the diaphragm.
 *
 * <p>No mesh shows this line. It is approximated {@value #HEIGHT_ABOVE_ORIGIN_MM} mm (about one rib) above the costal
 * origin of the diaphragm, which is its lower rim. For an origin at rib 11, this is rib 10 in the mid-axillary line.
 * Textbook limits of the pleura are ribs 8, 10 and 12 in the mid-clavicular, mid-axillary and paravertebral lines. A
 * path that enters the diaphragm above the line has crossed the recess.
 */
public final class PleuralReflection {
    /** Height of the reflection above the costal origin, mm. */
    public static final double HEIGHT_ABOVE_ORIGIN_MM = 20;

    private static final int SECTORS = 36;
    /** Minimum radius of rim vertices, as a fraction of the largest radius. Crura and tendon lie further inside. */
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

    /** Whether a point of the diaphragm, given by its rest position, lies above the reflection. */
    public boolean isAbove(double restX, double restY, double restZ) {
        double at = sector(restX, restY) - 0.5 + SECTORS;
        int below = (int) at % SECTORS;
        double fraction = at - Math.floor(at);
        double height = (1 - fraction) * rim[below] + fraction * rim[(below + 1) % SECTORS];
        return restZ > height + HEIGHT_ABOVE_ORIGIN_MM;
    }
}
