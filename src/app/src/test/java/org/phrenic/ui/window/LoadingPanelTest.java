package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JTextArea;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** The longest stage of an import is read whole, and lies over nothing. */
class LoadingPanelTest {
    /** Whoever goes to press Cancel finds it where it was. */
    @Test
    void aLongerSentenceMovesNothing() {
        EventThread.run(() -> {
            Theme.install(false);
            assertThat(places("short")).isEqualTo(places("building the diaphragm from the organs and bones"));
        });
    }

    private static List<Rectangle> places(String said) {
        LoadingPanel panel = new LoadingPanel("importing", "Cancel the import", () -> {});
        panel.show(said, 0.7);
        panel.setSize(panel.getPreferredSize());
        panel.doLayout();
        return Stream.of(panel.getComponents())
                .map(part ->
                        new Rectangle(panel.getWidth() - part.getX(), part.getY(), part.getWidth(), part.getHeight()))
                .toList();
    }

    @Test
    void theLongestStageIsReadWhole() {
        Rectangle2D[] end = new Rectangle2D[1];
        List<JComponent> parts = EventThread.get(() -> {
            Theme.install(false);
            LoadingPanel panel = new LoadingPanel("importing", "Cancel the import", () -> {});
            panel.show("building the diaphragm from the organs and bones that it touches", 0.7);
            panel.setSize(panel.getPreferredSize());
            panel.doLayout();
            JTextArea text = (JTextArea) panel.getComponent(0);
            end[0] = text.modelToView2D(text.getText().length());
            return Stream.of(panel.getComponents()).map(JComponent.class::cast).toList();
        });
        assertThat(end[0].getMaxY()).isLessThanOrEqualTo(parts.get(0).getHeight());
        for (JComponent part : parts) {
            assertThat(part.getWidth()).isGreaterThanOrEqualTo(part.getPreferredSize().width);
            assertThat(parts)
                    .filteredOn(other -> other != part)
                    .extracting(JComponent::getBounds)
                    .noneMatch((Rectangle other) -> other.intersects(part.getBounds()));
        }
    }
}
