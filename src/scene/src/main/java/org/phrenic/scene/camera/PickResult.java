package org.phrenic.scene.camera;

import org.phrenic.file.Numbers;
import org.phrenic.scene.style.StructureLabels;
import org.phrenic.simulation.observe.Surface;

/**
 * A picked point of a surface or of the cut face of its body. Arrays hold x, y, z and must not be modified.
 *
 * @param index index of the surface in the scene
 * @param position intersection of the line of sight with the surface or the cut face, LPS, mm
 * @param vertex vertex of the surface nearest to the position
 * @param restPosition position of the same point at end-expiration, mm
 * @param rayDirection direction of the line of sight
 * @param isOnCutFace whether the point lies inside the body, where a clip plane cuts it
 */
public record PickResult(
        int index,
        Surface surface,
        double[] position,
        int vertex,
        double[] restPosition,
        double[] rayDirection,
        boolean isOnCutFace) {
    /** Display name of the surface, such as "Rib 5 right". */
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

    /** The position with anatomical letters: {@code R 42 P 12 S 130 mm}. */
    public String positionText() {
        return positionText(x(), y(), z());
    }

    /** Formats a position in LPS, mm, with anatomical letters. */
    public static String positionText(double x, double y, double z) {
        return part(x, 'L', 'R') + " " + part(y, 'P', 'A') + " " + part(z, 'S', 'I') + " mm";
    }

    private static String part(double value, char positive, char negative) {
        long whole = Math.round(value);
        return Numbers.format("%s %d", whole < 0 ? negative : positive, Math.abs(whole));
    }
}
