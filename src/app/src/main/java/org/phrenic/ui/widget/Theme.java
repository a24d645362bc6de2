package org.phrenic.ui.widget;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.util.Map;
import javax.swing.UIManager;

/** Light and dark: one accent, quiet surfaces, the same sizes in both. */
public final class Theme {
    private static final String ACCENT_LIGHT = "#0f7285";
    private static final String ACCENT_DARK = "#4bb3c6";

    private Theme() {}

    /** Sets the look of all that is made from now on; what is there follows with {@link ThemeUpdater}. */
    public static void install(boolean dark) {
        FlatLaf.setGlobalExtraDefaults(Map.of("@accentColor", dark ? ACCENT_DARK : ACCENT_LIGHT));
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        UIManager.put("SplitPane.dividerSize", 5);
        UIManager.put("SplitPaneDivider.style", "plain");
        UIManager.put("TabbedPane.tabHeight", 28);
        UIManager.put("TabbedPane.tabInsets", new java.awt.Insets(2, 10, 2, 10));
        UIManager.put("ScrollBar.width", 11);
        UIManager.put("ScrollBar.thumbArc", 999);
        UIManager.put("Component.arc", 6);
        UIManager.put("Button.arc", 6);
        UIManager.put("TitlePane.unifiedBackground", true);
    }

    public static boolean isDark() {
        return FlatLaf.isLafDark();
    }

    public static Color accent() {
        return Color.decode(isDark() ? ACCENT_DARK : ACCENT_LIGHT);
    }

    /** Text that matters less; still 4.5 to 1 on a panel. */
    public static Color secondaryText() {
        return isDark() ? new Color(0xa9b0b5) : new Color(0x596067);
    }

    /** Line between regions. */
    public static Color borderColour() {
        Color separator = UIManager.getColor("Component.borderColor");
        return separator == null ? Color.GRAY : separator;
    }

    /** Behind the view until there is a picture; the renderer's own background. */
    public static Color viewBackground() {
        return isDark() ? new Color(0x1d2226) : new Color(0xe9edf0);
    }

    public static Color noteBackground() {
        return isDark() ? new Color(0x24363b) : new Color(0xe4f1f3);
    }

    public static Color noteText() {
        return isDark() ? new Color(0xd5ecf0) : new Color(0x0c4450);
    }

    public static Color warningBackground() {
        return isDark() ? new Color(0x4a3a10) : new Color(0xfff3cf);
    }

    public static Color warningText() {
        return isDark() ? new Color(0xffe3a0) : new Color(0x5b4300);
    }

    public static Color alarmBackground() {
        return isDark() ? new Color(0x5a2420) : new Color(0xfbe3e0);
    }

    public static Color alarmText() {
        return isDark() ? new Color(0xffd2cc) : new Color(0x7c1d12);
    }
}
