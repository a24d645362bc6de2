package org.phrenic.access;

import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;

/**
 * How low the pleura reaches on the diaphragm. The pleural recess is the space between the inner rib cage and the
 * diaphragm where no lung lies; it ends where the parietal pleura turns over from wall to diaphragm, above the
 * diaphragm's costal origin. No mesh shows that line, so it is taken {@value #HEIGHT_ABOVE_ORIGIN_MM} mm above the
 * sheet's lower rim, all around: about one rib, which puts it at rib 10 in the mid-axillary line with the origin at rib
 * 11 (the textbook's limits of the pleura are ribs 8, 10 and 12 in the mid-clavicular, mid-axillary and paravertebral
 * lines). A path that enters the sheet higher has crossed the recess.
 */
public final class PleuralReflection {
    /** Height of the reflection over the rim, mm. */
    public static final double HEIGHT_ABOVE_ORIGIN_MM = 20;

    private static final int SECTORS = 36;
    /** The rim is sought among what lies at least so far out, a share of the farthest: inside are crura and tendon. */
    private static final double OUTER = 0.75;

    private final double middleX;
    private final double middleY;
    private final double[] rim = new double[SECTORS];

    PleuralReflection(TriangleMesh sheet) {
        double[] box = sheet.bounds();
        middleX = 0.5 * (box[0] + box[3]);
        middleY = 0.5 * (box[1] + box[4]);
        double[] farthest = new double[SECTORS];
        for (int i = 0; i < sheet.vertexCount(); i++) {
            int sector = (int) sector(sheet.x(i), sheet.y(i)) % SECTORS;
            farthest[sector] = Math.max(farthest[sector], radius(sheet.x(i), sheet.y(i)));
        }
        Arrays.fill(rim, box[5]);
        for (int i = 0; i < sheet.vertexCount(); i++) {
            int sector = (int) sector(sheet.x(i), sheet.y(i)) % SECTORS;
            if (radius(sheet.x(i), sheet.y(i)) >= OUTER * farthest[sector]) {
                rim[sector] = Math.min(rim[sector], sheet.z(i));
            }
        }
    }

    private double radius(double x, double y) {
        return Math.sqrt((x - middleX) * (x - middleX) + (y - middleY) * (y - middleY));
    }

    private double sector(double x, double y) {
        double turn = StrictMath.atan2(y - middleY, x - middleX) / (2 * Math.PI);
        return (turn + 1) % 1 * SECTORS;
    }

    /** Whether a point of the sheet lies above the reflection, given where it rests. */
    public boolean isAbove(double restX, double restY, double restZ) {
        double at = sector(restX, restY) - 0.5 + SECTORS;
        int below = (int) at % SECTORS;
        double over = at - Math.floor(at);
        double here = (1 - over) * rim[below] + over * rim[(below + 1) % SECTORS];
        return restZ > here + HEIGHT_ABOVE_ORIGIN_MM;
    }
}
