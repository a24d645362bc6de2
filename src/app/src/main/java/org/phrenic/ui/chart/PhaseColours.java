package org.phrenic.ui.chart;

import java.awt.Color;
import java.util.Locale;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.ui.widget.Theme;

/**
 * Colour and name of what a breath is doing: blue in, orange out, grey for a pause, violet for a hold; told apart by
 * those who see few colours, and by their words.
 */
public final class PhaseColours {
    private PhaseColours() {}

    public static Color of(RespiratoryPhase label) {
        boolean dark = Theme.isDark();
        return new Color(
                switch (label) {
                    case INSPIRATION -> dark ? 0x2F6F9F : 0xA9D3F0;
                    case EXPIRATION -> dark ? 0x93592A : 0xF8CFA4;
                    case PAUSE -> dark ? 0x4A5157 : 0xD9DEE2;
                    case HOLD -> dark ? 0x665096 : 0xD3C4F1;
                });
    }

    static Color textColour() {
        return Theme.isDark() ? new Color(0xF2F4F5) : new Color(0x1E2428);
    }

    public static String displayName(RespiratoryPhase label) {
        String name = label.name();
        return name.charAt(0) + name.substring(1).toLowerCase(Locale.ROOT);
    }

    /** The label of a status; a pause if it has none. */
    public static RespiratoryPhase parseLabel(String phaseLabel) {
        for (RespiratoryPhase label : RespiratoryPhase.values()) {
            if (label.name().equalsIgnoreCase(phaseLabel)) {
                return label;
            }
        }
        return RespiratoryPhase.PAUSE;
    }
}
