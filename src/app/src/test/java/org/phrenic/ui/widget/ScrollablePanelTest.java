package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Insets;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;

/** A scroll pane without a border has none in the other theme either. */
class ScrollablePanelTest {
    @Test
    void aChangeOfTheThemeBringsNoBorder() {
        Insets insets = EventThread.get(() -> {
            Theme.install(false);
            JScrollPane scroll = ScrollablePanel.scrollPane(new ScrollablePanel(new MigLayout()));
            Theme.install(true);
            scroll.updateUI();
            Insets after = scroll.getInsets();
            Theme.install(false);
            return after;
        });
        assertThat(insets).isEqualTo(new Insets(0, 0, 0, 0));
    }
}
