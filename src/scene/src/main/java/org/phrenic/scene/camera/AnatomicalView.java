package org.phrenic.scene.camera;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.phrenic.document.KeySuggestion;

/**
 * The standard anatomical views, named by the side of the patient that is looked at. None is mirrored. From the front
 * the patient's right is on the left of the picture. From above ({@link #SUPERIOR}) the patient's front is at the
 * bottom and the left at the right; from below ({@link #INFERIOR}) the front is at the top and the left at the right,
 * as in an axial CT slice.
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

    /** Where the viewer stands about the patient's long axis, degrees: 0 in front, 90 at the patient's left. */
    public double azimuthDeg() {
        return azimuthDeg;
    }

    /** How high the viewer stands, degrees: 90 is right above. */
    public double elevationDeg() {
        return elevationDeg;
    }

    /** Its name in a command or a file name: {@code anterior}. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The same axis from the other end. */
    public AnatomicalView opposite() {
        return switch (this) {
            case ANTERIOR -> POSTERIOR;
            case POSTERIOR -> ANTERIOR;
            case LEFT -> RIGHT;
            case RIGHT -> LEFT;
            case SUPERIOR -> INFERIOR;
            case INFERIOR -> SUPERIOR;
        };
    }

    /**
     * The view of this name.
     *
     * @throws IllegalArgumentException if there is none; the sentence has the nearest name
     */
    public static AnatomicalView parse(String label) {
        String sought = label.strip().toLowerCase(Locale.ROOT);
        List<String> labels = Arrays.stream(values()).map(AnatomicalView::label).toList();
        return Arrays.stream(values())
                .filter(view -> view.label().equals(sought))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("found an unknown view '" + label + "', "
                        + KeySuggestion.nearest(sought, labels)
                                .map(near -> "did you mean '" + near + "'?")
                                .orElse("expected one of " + labels.stream().collect(Collectors.joining(", ")))));
    }
}
