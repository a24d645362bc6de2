package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.widget.ScrollablePanel;

/** Arrow keys that reach the needle from a dock. */
class NeedleKeysTest {
    private static final KeyStroke LEFT = KeyStroke.getKeyStroke("LEFT");
    private static final KeyStroke CTRL_UP = KeyStroke.getKeyStroke("ctrl UP");

    @Test
    void aDockInAScrollPaneTurnsTheNeedleByArrowKeys() {
        EventThread.run(() -> {
            List<String> done = new ArrayList<>();
            MenuAction turn = new MenuAction("Turn", "Turns", "LEFT", () -> done.add("turned"));
            MenuAction insert = new MenuAction("Insert", "Inserts", "I", () -> done.add("inserted"));
            ScrollablePanel dock = new ScrollablePanel();
            JScrollPane scroll = ScrollablePanel.scrollPane(dock);
            new NeedleKeys(List.of(turn, insert), new JPanel()).add(scroll);
            InputMap keys = dock.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
            assertThat(keys.keys()).containsExactly(LEFT);
            Action bound = dock.getActionMap().get(keys.get(LEFT));
            bound.actionPerformed(null);
            assertThat(done).containsExactly("turned");
            turn.setEnabled(false);
            assertThat(bound.isEnabled())
                    .as("so that the scroll pane gets the key")
                    .isFalse();
        });
    }

    /** Ctrl+Up moves the focus to the tabs, where plain arrow keys go to other docks. */
    @Test
    void aDockInTabsTiltsTheProbeByCtrlUpAndLeavesItToTheTabsWhileNothingIsRehearsed() {
        EventThread.run(() -> {
            List<String> done = new ArrayList<>();
            MenuAction tilt = new MenuAction("Tilt", "Tilts", "ctrl UP", () -> done.add("tilted"));
            JTabbedPane tabs = new JTabbedPane();
            tabs.addTab("Ultrasound", new JPanel());
            InputMap keys = tabs.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
            Object ofTabs = keys.get(CTRL_UP);
            assertThat(ofTabs).as("else the tabs are not in the way").isNotNull();
            new NeedleKeys(List.of(tilt), new JPanel()).add(tabs);
            tabs.getActionMap().put(ofTabs, new AbstractAction() {
                @Override
                public void actionPerformed(ActionEvent e) {
                    done.add("to the tabs");
                }
            });
            ActionEvent pressed = new ActionEvent(tabs, ActionEvent.ACTION_PERFORMED, "");
            Action bound = tabs.getActionMap().get(keys.get(CTRL_UP));
            bound.actionPerformed(pressed);
            assertThat(done).containsExactly("tilted");
            tilt.setEnabled(false);
            assertThat(bound.isEnabled()).isTrue();
            bound.actionPerformed(pressed);
            assertThat(done).containsExactly("tilted", "to the tabs");
        });
    }

    @Test
    void dividersLeaveArrowKeysToThePartsThatTheyDivide() {
        EventThread.run(() -> {
            DockLayout layout = new DockLayout(WindowPreferences.unsaved(), new JPanel());
            JSplitPane pane = (JSplitPane) layout.getComponent(0);
            Object moves = pane.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                    .get(LEFT);
            assertThat(pane.getActionMap().get(moves).isEnabled()).isFalse();
        });
    }
}
