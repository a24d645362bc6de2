package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComponent;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** The longest stage of an import is read whole, and lies over nothing. */
class LoadingPanelTest {
    @Test
    void theLongestStageIsReadWhole() {
        List<JComponent> parts = EventThread.get(() -> {
            Theme.install(false);
            LoadingPanel panel = new LoadingPanel("importing", "Cancel the import", () -> {});
            panel.show("building the diaphragm from the organs and bones that it touches", 0.7);
            panel.setSize(panel.getPreferredSize());
            panel.doLayout();
            return Stream.of(panel.getComponents()).map(JComponent.class::cast).toList();
        });
        for (JComponent part : parts) {
            assertThat(part.getWidth()).isGreaterThanOrEqualTo(part.getPreferredSize().width);
            assertThat(parts)
                    .filteredOn(other -> other != part)
                    .extracting(JComponent::getBounds)
                    .noneMatch((Rectangle other) -> other.intersects(part.getBounds()));
        }
    }
}
