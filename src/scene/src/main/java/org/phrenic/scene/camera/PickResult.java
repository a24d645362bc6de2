package org.phrenic.scene.camera;

import java.util.Locale;
import org.phrenic.simulation.observe.Surface;

/**
 * What lies under the cursor.
 *
 * @param index number of the surface in the scene
 * @param surface the surface
 * @param displayName its name for people, such as "Rib 5 right"
 * @param x where the line of sight meets it, LPS, mm
 * @param y as above
 * @param z as above
 * @param vertex its vertex nearest to that place
 * @param restPosition where that place of the surface is at end-expiration; three numbers, not to be written to
 * @param rayDirection direction of the line of sight; three numbers, not to be written to
 */
public record PickResult(
        int index,
        Surface surface,
        String displayName,
        double x,
        double y,
        double z,
        int vertex,
        double[] restPosition,
        double[] rayDirection) {
    /** The place in a clinician's words: {@code R 42 P 12 S 130 mm}. */
    public String positionText() {
        return positionText(x, y, z);
    }

    /** A place in LPS, mm, in a clinician's words. */
    public static String positionText(double x, double y, double z) {
        return part(x, 'L', 'R') + " " + part(y, 'P', 'A') + " " + part(z, 'S', 'I') + " mm";
    }

    private static String part(double value, char positive, char negative) {
        long whole = Math.round(value);
        return String.format(Locale.ROOT, "%s %d", whole < 0 ? negative : positive, Math.abs(whole));
    }
}
