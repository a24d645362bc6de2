package org.phrenic.ui.chart;

import java.awt.Color;
import java.util.List;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.widget.Theme;

/**
 * A curve of the plot: an observable, or the displacement of a picked point. The colours are those of Okabe and Ito
 * (jfly.uni-koeln.de/color), made for colour vision deficiency, darkened on white and lightened on black to a contrast
 * of 3 and more; neighbours differ by dashes too.
 *
 * @param column name in {@code observables.csv}
 * @param index column of the {@link SampleRingBuffer}
 * @param label name in the legend
 * @param unit unit; {@code 1} for a plain number
 * @param colour of the line
 * @param dashed whether the line is dashed
 * @param meaning where it is measured
 */
record PlotCurve(String column, int index, String label, String unit, Color colour, boolean dashed, String meaning) {
    static final int MAX_POINTS = 4;

    private static final List<PlotCurve> OBSERVABLES = List.of(
            of("dome_right_mm", "Dome right", 0x0072B2, 0x56B4E9, false, "right dome, up positive"),
            of("dome_left_mm", "Dome left", 0xD55E00, 0xFF9349, false, "left dome, up positive"),
            of("central_tendon_mm", "Central tendon", 0x5A5A5A, 0xC9C9C9, true, "median leaflet, up positive"),
            of("ap_change_mm", "AP diameter", 0x00805E, 0x35CFA2, false, "increase of the AP diameter"),
            of("transverse_change_mm", "Transverse", 0xA8497F, 0xF09AC8, true, "increase of the transverse diameter"),
            of("liver_si_mm", "Liver", 0x8A6A00, 0xF0D048, true, "displacement of the liver, superior positive"),
            of("lung_volume_change_ml", "Lung volume", 0x6B49B0, 0xB7A0F5, false, "air taken in"),
            of("fibre_shortening_percent", "Fibre shortening", 0x9C3324, 0xFF9F8E, false, "of the muscle's fibres"),
            of("rib_turn", "Rib turn", 0x4A6B12, 0xACD35C, false, "share of the ribs' full turn"));

    private static final int[] POINTS_LIGHT = {0x7A4A00, 0x005F73, 0x8C2D78, 0x3D5A00};
    private static final int[] POINTS_DARK = {0xE9B872, 0x6FD3E3, 0xF0A0E0, 0xB9DB76};

    /** The curves of every scene. */
    static List<PlotCurve> ofObservables() {
        return OBSERVABLES;
    }

    private static PlotCurve of(String column, String label, int light, int dark, boolean dashed, String meaning) {
        int index = Observation.COLUMNS.indexOf(column);
        String unit =
                switch (column.substring(column.lastIndexOf('_') + 1)) {
                    case "mm" -> "mm";
                    case "ml" -> "ml";
                    case "percent" -> "%";
                    default -> "1";
                };
        return new PlotCurve(column, index, label, unit, Theme.colour(light, dark), dashed, meaning);
    }

    /** The displacement of a picked point along the body's axis. */
    static PlotCurve ofPoint(int slot) {
        return new PlotCurve(
                "point_" + (slot + 1) + "_up_mm",
                Observation.COLUMNS.size() + slot,
                "Point " + (slot + 1),
                "mm",
                Theme.colour(POINTS_LIGHT[slot], POINTS_DARK[slot]),
                slot % 2 == 1,
                "displacement of the picked point since it was picked, up positive");
    }

    int decimals() {
        return switch (unit) {
            case "ml" -> 0;
            case "1" -> 3;
            default -> 1;
        };
    }
}
