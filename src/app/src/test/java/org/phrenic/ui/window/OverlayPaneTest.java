package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.SessionMessage;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.widget.Theme;

/** The welcome panel and the view share the middle of the window. */
class OverlayPaneTest {
    /** Room for docks and view in the smallest window, pixels. */
    private static final int WIDTH = 790;

    private static final int HEIGHT = 390;

    /** The first line of the view tells the side and the moment that are seen. */
    @Test
    void aMessageLeavesTheFirstLineOfTheViewInSight() {
        EventThread.run(() -> {
            Theme.install(false);
            MessageBanner banner = new MessageBanner();
            WelcomePanel welcome = new WelcomePanel(workspace -> {}, () -> {});
            welcome.setVisible(false);
            OverlayPane pane = new OverlayPane(
                    new JPanel(),
                    banner,
                    new LoadingPanel("loading", "Stop", () -> {}),
                    new LoadingPanel("importing", "Stop", () -> {}),
                    welcome);
            banner.show(new SessionMessage(SessionMessage.Kind.NOTE, "Saved a.png."));
            pane.setSize(640, 480);
            pane.doLayout();
            assertThat(banner.getY()).isGreaterThanOrEqualTo(36);
        });
    }

    @Test
    void theViewIsMoreThanAStripBelowTheWelcomePanelInTheSmallestWindow() {
        EventThread.run(() -> {
            Theme.install(false);
            JPanel view = new JPanel();
            WelcomePanel welcome = new WelcomePanel(workspace -> {}, () -> {});
            DockLayout layout = new DockLayout(
                    WindowPreferences.unsaved(),
                    new OverlayPane(
                            view,
                            new MessageBanner(),
                            new LoadingPanel("loading", "Stop", () -> {}),
                            new LoadingPanel("importing", "Stop", () -> {}),
                            welcome));
            layout.useSizesOf(Workspace.RESEARCHER);
            for (DockLayout.Place place : DockLayout.Place.values()) {
                layout.setDock(place, new JPanel());
            }
            layout.endChange();
            layout.addNotify();
            layout.setSize(WIDTH, HEIGHT);
            // The panel arranges itself for its width, and its height is another.
            for (int i = 0; i < 3; i++) {
                layout.validate();
                layout.invalidate();
            }
            assertThat(welcome.getHeight()).isGreaterThan(60);
            assertThat(view.getHeight()).isGreaterThan(125);
            assertThat(layout.dock(DockLayout.Place.BOTTOM).getHeight()).isGreaterThanOrEqualTo(90);
        });
    }
}
