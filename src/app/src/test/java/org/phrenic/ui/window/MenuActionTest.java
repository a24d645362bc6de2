package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;

/** Which keys are typed into the part in focus, and which are commands to the window. */
class MenuActionTest {
    @Test
    void anItemShowsTheStateOfWhatItSwitches() {
        boolean[] shown = {true};
        MenuAction action =
                new MenuAction("Plots", "Show or hide", null, () -> shown[0] = !shown[0]).withState(() -> shown[0]);
        JCheckBoxMenuItem item = new JCheckBoxMenuItem(action);
        action.showState();
        assertThat(item.isSelected()).isTrue();
        action.run();
        action.showState();
        assertThat(item.isSelected()).isFalse();
    }

    private static boolean isTyped(int code, int modifiers, Component focused) {
        KeyEvent key = new KeyEvent(new JPanel(), KeyEvent.KEY_PRESSED, 0, modifiers, code, KeyEvent.CHAR_UNDEFINED);
        return MenuAction.isTyped(key, focused);
    }

    @Test
    void aLetterGoesToTheFieldListTableOrChoiceInFocus() {
        List<Component> selecting = List.of(new JTextField(), new JList<>(), new JTable(), new JComboBox<>());
        for (Component focused : selecting) {
            assertThat(isTyped(KeyEvent.VK_X, 0, focused)).isTrue();
            assertThat(isTyped(KeyEvent.VK_X, InputEvent.SHIFT_DOWN_MASK, focused))
                    .isTrue();
            assertThat(isTyped(KeyEvent.VK_Z, InputEvent.CTRL_DOWN_MASK, focused))
                    .as("a command")
                    .isFalse();
            assertThat(isTyped(KeyEvent.VK_F1, 0, focused)).isFalse();
        }
    }

    @Test
    void aLetterIsACommandWhileAButtonOrNothingHasTheFocus() {
        assertThat(isTyped(KeyEvent.VK_X, 0, new JButton())).isFalse();
        assertThat(isTyped(KeyEvent.VK_X, 0, null)).isFalse();
        JTextField shown = new JTextField();
        shown.setEditable(false);
        assertThat(isTyped(KeyEvent.VK_X, 0, shown)).isFalse();
    }
}
