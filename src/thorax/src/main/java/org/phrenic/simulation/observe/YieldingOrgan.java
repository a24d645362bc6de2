package org.phrenic.simulation.observe;

import java.util.Locale;
import java.util.regex.Pattern;
import org.phrenic.anatomy.Structure;

/**
 * A soft organ beside the moving diaphragm: its vertices yield ({@link SheetContact}). A kidney keeps its shape as far
 * as it can: it is first shifted as a whole by the mean way of those of its vertices that would yield, {@value #ROUNDS}
 * times. The shift is a continuous function of the state. What of it there is at rest already is left out: there an
 * organ keeps its place in the scan.
 */
public final class YieldingOrgan {
    private static final Pattern FIRM = Pattern.compile("kidney_.*");
    private static final int ROUNDS = 4;

    private final SheetContact.Organ contact;
    /** Contact while the organ is shifted; null if it is not. */
    private final SheetContact.Organ whole;

    private final double[] now;
    private final double[] moved;
    private final double[] shift = new double[3];
    private final double[] atRest;

    /**
     * @param sheet the diaphragm, at rest
     * @param organ at rest
     * @param above whether the organ lies above the thoracic face; else below the abdominal face
     */
    public YieldingOrgan(SheetContact sheet, Structure organ, boolean above) {
        double[] rest = organ.mesh().positions();
        contact = sheet.organ(rest, above);
        now = rest.clone();
        moved = rest.clone();
        boolean firm = FIRM.matcher(organ.name().toLowerCase(Locale.ROOT)).matches();
        whole = firm ? sheet.organ(rest, above) : null;
        if (firm) {
            findShift();
        }
        atRest = shift.clone();
    }

    /** The organ's points where the diaphragm is now; valid until the next call. Allocates nothing. */
    public double[] at(double[] points) {
        System.arraycopy(points, 0, now, 0, now.length);
        if (whole != null) {
            findShift();
            double along = dot(shift, atRest) / Math.max(dot(atRest, atRest), Double.MIN_NORMAL);
            double share = Math.max(0, Math.min(1, along));
            for (int i = 0; i < now.length; i++) {
                now[i] = points[i] + shift[i % 3] - share * atRest[i % 3];
            }
        }
        contact.pushBack(now);
        return now;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** Finds by how much the organ is shifted as a whole, and shifts it. */
    private void findShift() {
        shift[0] = 0;
        shift[1] = 0;
        shift[2] = 0;
        for (int round = 0; round < ROUNDS; round++) {
            System.arraycopy(now, 0, moved, 0, now.length);
            whole.pushBack(moved);
            if (!shiftByMeanWay()) {
                return;
            }
        }
    }

    /** Moves all points by the mean way of those that yielded; false if none did. */
    private boolean shiftByMeanWay() {
        double x = 0;
        double y = 0;
        double z = 0;
        int count = 0;
        for (int k = 0; k < now.length; k += 3) {
            if (moved[k] != now[k] || moved[k + 1] != now[k + 1] || moved[k + 2] != now[k + 2]) {
                x += moved[k] - now[k];
                y += moved[k + 1] - now[k + 1];
                z += moved[k + 2] - now[k + 2];
                count++;
            }
        }
        if (count == 0) {
            return false;
        }
        shift[0] += x / count;
        shift[1] += y / count;
        shift[2] += z / count;
        for (int k = 0; k < now.length; k += 3) {
            now[k] += x / count;
            now[k + 1] += y / count;
            now[k + 2] += z / count;
        }
        return true;
    }
}
