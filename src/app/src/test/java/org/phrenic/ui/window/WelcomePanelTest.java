package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** The card that a newcomer reads first. */
class WelcomePanelTest {
    /** Width of the view in a window at first use on a screen of 1280 x 800, pixels. */
    private static final int VIEW_WIDTH = 535;

    @Test
    void everyLineIsReadWholeOnASmallScreen() {
        List<JLabel> cut = EventThread.get(() -> {
            Theme.install(false);
            WelcomePanel panel = new WelcomePanel(workspace -> {}, () -> {});
            panel.setSize(VIEW_WIDTH, panel.getPreferredSize().height);
            panel.doLayout();
            return Stream.of(panel.getComponents())
                    .filter(JLabel.class::isInstance)
                    .map(JLabel.class::cast)
                    .filter(line -> line.getWidth() < line.getPreferredSize().width)
                    .toList();
        });
        assertThat(cut).extracting(JLabel::getText).isEmpty();
    }
}
