package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.util.UIScale;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Swatch;
import org.phrenic.ui.widget.Theme;

/** What surrounds letters grows with them, as by {@code -Dflatlaf.uiScale=1.75}. */
@Isolated
class LargeLettersTest {
    private static final float LARGE = 1.75f;

    private static void withLargeLetters(Runnable test) {
        EventThread.run(() -> {
            UIScale.setZoomFactor(LARGE);
            try {
                Theme.install(false);
                test.run();
            } finally {
                UIScale.setZoomFactor(1);
                Theme.install(false);
            }
        });
    }

    @Test
    void iconsGrow() {
        withLargeLetters(() -> {
            assertThat(Icons.PLAY.getIconWidth()).isEqualTo(28);
            assertThat(new Swatch(20, 8, g -> {}).getIconHeight()).isEqualTo(14);
        });
        assertThat(Icons.PLAY.getIconWidth()).isEqualTo(16);
    }

    @Test
    void docksGrowAndAreKeptInUsualSize() {
        withLargeLetters(() -> {
            WindowPreferences preferences = WindowPreferences.unsaved();
            preferences.setNumber("dock.RIGHT", 320);
            JPanel right = new JPanel();
            DockLayout layout = new DockLayout(preferences, new JPanel());
            layout.useSizesOf(Workspace.RESEARCHER);
            layout.setDock(DockLayout.Place.RIGHT, right);
            layout.endChange();
            layout.addNotify();
            layout.setSize(1600, 900);
            layout.validate();
            assertThat(right.getWidth()).isEqualTo(560);
            layout.saveSizes();
            assertThat(preferences.number("dock.RIGHT", 0)).isEqualTo(320);
        });
    }
}
