package org.phrenic.ui.widget;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.Insets;
import java.util.Map;
import java.util.function.IntSupplier;
import javax.swing.UIManager;

/**
 * Light and dark look and feel: one accent, the same sizes in both. The colours here follow the look and feel, so a
 * component keeps the colour object when the look and feel changes.
 */
public final class Theme {
    public static final Color ACCENT = colour(0x0f7285, 0x4bb3c6);
    public static final Color TEXT = colour(0x1e2428, 0xe8ecee);

    /** Text that matters less; a contrast of 4.5 to 1 and more on a panel. */
    public static final Color SECONDARY_TEXT = colour(0x596067, 0xa9b0b5);

    /** Line between regions. */
    public static final Color BORDER = new ThemeColour(() -> {
        Color border = UIManager.getColor("Component.borderColor");
        return (border == null ? Color.GRAY : border).getRGB();
    });

    /** Behind the view until there is a picture; a shade between those of the renderer's background. */
    public static final Color VIEW_BACKGROUND = colour(0xe9edf0, 0x1d2226);

    public static final Color NOTE_BACKGROUND = colour(0xe4f1f3, 0x24363b);
    public static final Color NOTE_TEXT = colour(0x0c4450, 0xd5ecf0);
    public static final Color WARNING_BACKGROUND = colour(0xfff3cf, 0x4a3a10);
    public static final Color WARNING_TEXT = colour(0x5b4300, 0xffe3a0);
    public static final Color ALARM_BACKGROUND = colour(0xfbe3e0, 0x5a2420);
    public static final Color ALARM_TEXT = colour(0x7c1d12, 0xffd2cc);

    private Theme() {}

    private static final class ThemeColour extends Color {
        private final transient IntSupplier argb;

        ThemeColour(IntSupplier argb) {
            super(0);
            this.argb = argb;
        }

        @Override
        public int getRGB() {
            return argb.getAsInt();
        }
    }

    /** A colour with one value, RGB, on a light and one on a dark background. */
    public static Color colour(int light, int dark) {
        return new ThemeColour(() -> 0xff000000 | (isDark() ? dark : light));
    }

    /** A colour of this moment with an opacity of 0 to 255. */
    public static Color withAlpha(Color colour, int alpha) {
        return new Color((colour.getRGB() & 0xffffff) | (alpha << 24), true);
    }

    /** Sets the look and feel of components made from here on; existing ones follow by {@link ThemeUpdater}. */
    public static void install(boolean dark) {
        FlatLaf.setGlobalExtraDefaults(Map.of("@accentColor", dark ? "#4bb3c6" : "#0f7285"));
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        UIManager.put("ComboBox.noActionOnKeyNavigation", true);
        UIManager.put("SplitPane.dividerSize", 5);
        UIManager.put("SplitPaneDivider.style", "plain");
        UIManager.put("TabbedPane.tabHeight", 28);
        UIManager.put("TabbedPane.tabInsets", new Insets(2, 10, 2, 10));
        UIManager.put("ScrollBar.width", 11);
        UIManager.put("ScrollBar.thumbArc", 999);
        UIManager.put("Component.arc", 6);
        UIManager.put("Button.arc", 6);
        UIManager.put("TitlePane.unifiedBackground", true);
    }

    public static boolean isDark() {
        return FlatLaf.isLafDark();
    }
}
