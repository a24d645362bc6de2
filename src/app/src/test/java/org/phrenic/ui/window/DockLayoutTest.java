package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.JPanel;
import javax.swing.JSplitPane;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.widget.Theme;

/** Widths of the docks in windows of all sizes. */
class DockLayoutTest {
    private static final int WIDE = 1400;
    private static final int NARROW = 790;
    private static final int HEIGHT = 700;

    private final WindowPreferences preferences = WindowPreferences.unsaved();
    private final JPanel left = new JPanel();
    private final JPanel right = new JPanel();

    private DockLayout layout() {
        Theme.install(false);
        DockLayout layout = new DockLayout(preferences, new JPanel());
        layout.useSizesOf(Workspace.CLINICIAN);
        layout.setDock(DockLayout.Place.LEFT, left);
        layout.setDock(DockLayout.Place.RIGHT, right);
        layout.endChange();
        // Is validated as in a window.
        layout.addNotify();
        return layout;
    }

    private static void resize(DockLayout layout, int width) {
        layout.setSize(width, HEIGHT);
        layout.validate();
    }

    @Test
    void aNarrowWindowTakesWidthFromTheLeftFirst() {
        EventThread.run(() -> {
            DockLayout layout = layout();
            resize(layout, NARROW);
            assertThat(right.getWidth()).isBetween(300, 368);
            assertThat(left.getWidth()).isBetween(215, 220);
            resize(layout, 1000);
            assertThat(right.getWidth()).isBetween(363, 368);
        });
    }

    @Test
    void widthsThatAWindowForcesAreNeitherKeptNorSaved() {
        EventThread.run(() -> {
            DockLayout layout = layout();
            resize(layout, NARROW);
            layout.saveSizes();
            assertThat(preferences.number("dock.clinician.LEFT", 0)).isEqualTo(392);
            assertThat(preferences.number("dock.clinician.RIGHT", 0)).isEqualTo(368);
            resize(layout, WIDE);
            assertThat(left.getWidth()).isEqualTo(392);
            assertThat(right.getWidth()).isEqualTo(368);
        });
    }

    @Test
    void aDividerThatIsMovedIsKeptAndSaved() {
        EventThread.run(() -> {
            DockLayout layout = layout();
            resize(layout, WIDE);
            ((JSplitPane) left.getParent()).setDividerLocation(330);
            left.getParent().validate();
            layout.saveSizes();
            assertThat(preferences.number("dock.clinician.LEFT", 0)).isEqualTo(330);
            resize(layout, WIDE - 50);
            assertThat(left.getWidth()).isEqualTo(330);
        });
    }
}
