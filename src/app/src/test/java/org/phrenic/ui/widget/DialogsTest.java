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
        assertThat(answerByEnter(() -> Dialogs.confirm(null, "Settings", "Delete?")))
                .isEqualTo("No");
        assertThat(answerByEnter(() -> Dialogs.confirmRisk(null, "Quit", "Close?", "Close")))
                .isEqualTo("Cancel");
    }

    /** Attempts that cannot be written at the end would be lost by a key pressed in haste. */
    @Test
    void theEnterKeyTriesAgainWhereItWouldLoseSomethingElse() {
        assertThat(answerByEnter(() -> Dialogs.confirmRetry(null, "Attempts", "Not written.", "Lose them")))
                .isEqualTo("Try again");
    }

    private static Object answerByEnter(Runnable asks) {
        WindowHarness.assumeDisplay();
        try {
            EventThread.run(() -> SwingUtilities.invokeLater(asks));
            EventThread.until("the question", () -> ShownDialogs.question().isPresent());
            return EventThread.get(() -> ShownDialogs.question().orElseThrow().getInitialValue());
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
