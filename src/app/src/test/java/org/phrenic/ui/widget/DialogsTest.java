package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTKeyStroke;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.util.Set;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.window.ShownDialogs;
import org.phrenic.ui.window.WindowHarness;

class DialogsTest {
    /** The buttons at its foot would lie below the screen. */
    @Test
    void aDialogIsNoLargerThanItsScreen() {
        WindowHarness.assumeDisplay();
        EventThread.run(() -> {
            JDialog dialog = Dialogs.of(null, "Large", new JPanel(), new Dimension(100_000, 100_000), "");
            Rectangle screen = dialog.getGraphicsConfiguration().getBounds();
            assertThat(dialog.getWidth()).isLessThanOrEqualTo(screen.width);
            assertThat(dialog.getHeight()).isLessThanOrEqualTo(screen.height);
            dialog.dispose();
        });
    }

    @Test
    void theEnterKeyReplacesAndDeletesNothing() {
        WindowHarness.assumeDisplay();
        try {
            EventThread.run(() -> SwingUtilities.invokeLater(() -> Dialogs.confirm(null, "Settings", "Delete?")));
            EventThread.until("the question", () -> ShownDialogs.question().isPresent());
            assertThat(EventThread.get(
                            () -> ShownDialogs.question().orElseThrow().getInitialValue()))
                    .isEqualTo("No");
        } finally {
            EventThread.run(ShownDialogs::close);
        }
    }

    @Test
    void theTabKeyLeavesATable() {
        Set<AWTKeyStroke> leaving = EventThread.get(() -> {
            JTable table = Dialogs.table("Keys", new String[][] {{"Space", "Play"}}, "Key", "Does");
            return table.getFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS);
        });
        assertThat(leaving).contains(AWTKeyStroke.getAWTKeyStroke("TAB"));
    }
}
