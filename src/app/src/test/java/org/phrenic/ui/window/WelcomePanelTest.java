package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComponent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** The card that a newcomer reads first. */
class WelcomePanelTest {
    /**
     * Widths of the view: in a window at first use on a screen of 1280 x 800, in the smallest window, and in that with
     * wide docks, pixels.
     */
    @ParameterizedTest
    @ValueSource(ints = {535, 300, 230})
    void everyLineIsReadWhole(int width) {
        List<JComponent> cut = EventThread.get(() -> {
            Theme.install(false);
            WelcomePanel panel = new WelcomePanel(workspace -> {}, () -> {});
            panel.setSize(width, 1);
            panel.setSize(width, panel.getPreferredSize().height);
            panel.doLayout();
            return Stream.of(panel.getComponents())
                    .map(JComponent.class::cast)
                    .filter(part -> part.getWidth() < part.getPreferredSize().width
                            || part.getHeight() < part.getPreferredSize().height)
                    .toList();
        });
        assertThat(cut).extracting(JComponent::getName).isEmpty();
    }
}
