package org.phrenic.ui;

import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;

/** The digits of the number pad do what the digits of the keyboard do. */
final class NumberPad {
    private NumberPad() {}

    static void bind(JRootPane root, List<Command> commands) {
        for (Command command : commands) {
            KeyStroke key = command.key();
            if (key != null && key.getKeyCode() >= KeyEvent.VK_0 && key.getKeyCode() <= KeyEvent.VK_9) {
                int pad = KeyEvent.VK_NUMPAD0 + key.getKeyCode() - KeyEvent.VK_0;
                root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
                        .put(KeyStroke.getKeyStroke(pad, key.getModifiers()), command.name());
                root.getActionMap().put(command.name(), command);
            }
        }
    }
}
