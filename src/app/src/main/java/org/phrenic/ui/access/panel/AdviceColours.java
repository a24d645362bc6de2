package org.phrenic.ui.access.panel;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.scene.NeedleMarkers;

/** Colours of what is said: green, amber and red are told apart by lightness and by their words too. */
final class AdviceColours {
    private AdviceColours() {}

    static boolean isDark() {
        return FlatLaf.isLafDark();
    }

    /** The mark of a level, as the way to the target has it in the view. */
    static Color pathColour(PathAdvice.Level level) {
        return new Color(NeedleMarkers.rgb(level));
    }

    static Color background(PathAdvice.Level level) {
        return new Color(
                switch (level) {
                    case FREE -> isDark() ? 0x17383a : 0xe2f3f0;
                    case CAREFUL -> isDark() ? 0x463510 : 0xfff2d6;
                    case BARRED -> isDark() ? 0x52241e : 0xfbe3df;
                });
    }

    static Color text(PathAdvice.Level level) {
        return new Color(
                switch (level) {
                    case FREE -> isDark() ? 0xc9f0ea : 0x0a4a43;
                    case CAREFUL -> isDark() ? 0xffe1a3 : 0x5c3c00;
                    case BARRED -> isDark() ? 0xffd0c8 : 0x7a1a0e;
                });
    }

    static Color viewBackground() {
        return isDark() ? new Color(0x1d2226) : new Color(0xf2f5f7);
    }

    static Color textColour() {
        return isDark() ? new Color(0xe8ecee) : new Color(0x1e2428);
    }

    static Color secondaryText() {
        return isDark() ? new Color(0xa9b0b5) : new Color(0x596067);
    }
}
