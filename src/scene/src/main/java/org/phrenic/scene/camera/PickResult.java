package org.phrenic.scene.camera;

import java.util.Locale;
import org.phrenic.scene.style.StructureLabels;
import org.phrenic.simulation.observe.Surface;

/**
 * What lies under the cursor. Arrays hold three numbers and are not to be written to.
 *
 * @param index number of the surface in the scene
 * @param position where the line of sight meets the surface, LPS, mm
 * @param vertex the surface's vertex nearest to the position
 * @param restPosition where that point of the surface is at end-expiration, mm
 * @param rayDirection direction of the line of sight
 */
public record PickResult(
        int index, Surface surface, double[] position, int vertex, double[] restPosition, double[] rayDirection) {
    /** The surface's name for people, such as "Rib 5 right". */
    public String displayName() {
        return StructureLabels.of(surface);
    }

    public double x() {
        return position[0];
    }

    public double y() {
        return position[1];
    }

    public double z() {
        return position[2];
    }

    /** The position in anatomical directions: {@code R 42 P 12 S 130 mm}. */
    public String positionText() {
        return positionText(x(), y(), z());
    }

    /** A position in LPS, mm, in anatomical directions. */
    public static String positionText(double x, double y, double z) {
        return part(x, 'L', 'R') + " " + part(y, 'P', 'A') + " " + part(z, 'S', 'I') + " mm";
    }

    private static String part(double value, char positive, char negative) {
        long whole = Math.round(value);
        return String.format(Locale.ROOT, "%s %d", whole < 0 ? negative : positive, Math.abs(whole));
    }
}
