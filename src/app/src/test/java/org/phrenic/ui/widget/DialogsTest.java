package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTKeyStroke;
import java.awt.KeyboardFocusManager;
import java.util.Set;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;

class DialogsTest {
    @Test
    void theTabKeyLeavesATable() {
        Set<AWTKeyStroke> leaving = EventThread.get(() -> {
            JTable table = Dialogs.table("Keys", new String[][] {{"Space", "Play"}}, "Key", "Does");
            return table.getFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS);
        });
        assertThat(leaving).contains(AWTKeyStroke.getAWTKeyStroke("TAB"));
    }
}
