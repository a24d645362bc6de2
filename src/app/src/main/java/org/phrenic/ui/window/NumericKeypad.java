package org.phrenic.ui.window;

import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;

/** The digits of the number pad do what the digits of the keyboard do. */
final class NumericKeypad {
    private NumericKeypad() {}

    static void bind(JRootPane root, List<MenuAction> commands) {
        for (MenuAction command : commands) {
            KeyStroke key = command.accelerator();
            if (key != null && key.getKeyCode() >= KeyEvent.VK_0 && key.getKeyCode() <= KeyEvent.VK_9) {
                int pad = KeyEvent.VK_NUMPAD0 + key.getKeyCode() - KeyEvent.VK_0;
                root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
                        .put(KeyStroke.getKeyStroke(pad, key.getModifiers()), command.name());
                root.getActionMap().put(command.name(), command);
            }
        }
    }
}
