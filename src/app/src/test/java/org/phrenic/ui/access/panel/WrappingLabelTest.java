package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.JScrollPane;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.ScrollablePanel;

/** Texts that wrap in a dock that scrolls. */
class WrappingLabelTest {
    /** A report card begins with its verdict, however long the texts below it are. */
    @Test
    void aTextThatChangesDoesNotScrollToItsEnd() {
        JScrollPane scroll = EventThread.get(() -> {
            WrappingLabel text = WrappingLabel.normal("Measures");
            ScrollablePanel dock = new ScrollablePanel();
            dock.add(text);
            JScrollPane pane = ScrollablePanel.scrollPane(dock);
            text.setTextIfChanged("A line of many.\n".repeat(50));
            pane.setSize(200, 100);
            pane.doLayout();
            pane.getViewport().doLayout();
            dock.doLayout();
            text.setTextIfChanged("Another line of many.\n".repeat(50));
            return pane;
        });
        EventThread.run(() -> {});
        assertThat(EventThread.get(() -> scroll.getViewport().getViewPosition().y))
                .isZero();
    }
}
