package org.phrenic.scene.camera;

import java.util.Locale;

/**
 * The standard anatomical views, named by the visible side of the patient. None is mirrored. From the front, the
 * patient's right is on the left of the picture. From above ({@link #SUPERIOR}), the patient's front is at the bottom
 * and the patient's left at the right. From below ({@link #INFERIOR}), the front is at the top and the patient's left
 * at the right, as in an axial CT slice.
 */
public enum AnatomicalView {
    ANTERIOR(0, 0),
    POSTERIOR(180, 0),
    LEFT(90, 0),
    RIGHT(-90, 0),
    SUPERIOR(0, 90),
    INFERIOR(0, -90);

    private final double azimuthDeg;
    private final double elevationDeg;

    AnatomicalView(double azimuthDeg, double elevationDeg) {
        this.azimuthDeg = azimuthDeg;
        this.elevationDeg = elevationDeg;
    }

    /** Azimuth of the viewer about the patient's long axis, degrees: 0 in front, 90 at the patient's left. */
    public double azimuthDeg() {
        return azimuthDeg;
    }

    /** Elevation of the viewer, degrees: 90 is directly above. */
    public double elevationDeg() {
        return elevationDeg;
    }

    /** Name in commands and file names, such as {@code anterior}. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
