package org.phrenic.ui.window;

import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.Icon;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;

/** An action with a menu item, perhaps an accelerator key and a button of the tool bar. */
final class MenuAction extends AbstractAction {
    private static final int COMMAND_KEYS =
            InputEvent.CTRL_DOWN_MASK | InputEvent.META_DOWN_MASK | InputEvent.ALT_DOWN_MASK;

    private final transient Runnable operation;

    /**
     * @param name in menus
     * @param tip in one sentence
     * @param key accelerator as {@link KeyStroke#getKeyStroke(String)} takes it, where {@code menu} stands for Ctrl or
     *     the platform's own modifier; null for none
     */
    MenuAction(String name, String tip, String key, Runnable operation) {
        super(name);
        this.operation = operation;
        putValue(SHORT_DESCRIPTION, tip);
        if (key != null) {
            putValue(ACCELERATOR_KEY, parseKeyStroke(key));
        }
    }

    /** With an icon for the tool bar. */
    MenuAction withIcon(Icon icon) {
        putValue(Action.LARGE_ICON_KEY, icon);
        return this;
    }

    private static KeyStroke parseKeyStroke(String key) {
        KeyStroke plain = KeyStroke.getKeyStroke(key.replace("menu ", ""));
        int menu = key.contains("menu ") ? Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx() : 0;
        return KeyStroke.getKeyStroke(plain.getKeyCode(), plain.getModifiers() | menu);
    }

    String name() {
        return (String) getValue(NAME);
    }

    String tip() {
        return (String) getValue(SHORT_DESCRIPTION);
    }

    KeyStroke accelerator() {
        return (KeyStroke) getValue(ACCELERATOR_KEY);
    }

    /** {@code Ctrl+Shift+Z}; empty for none. */
    String acceleratorText() {
        KeyStroke key = accelerator();
        if (key == null) {
            return "";
        }
        String modifiers = InputEvent.getModifiersExText(key.getModifiers());
        return (modifiers.isEmpty() ? "" : modifiers + "+") + KeyEvent.getKeyText(key.getKeyCode());
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        if (!isTextInput()) {
            operation.run();
        }
    }

    /** Whether the event is a character typed into a text field, though the character is an accelerator too. */
    private static boolean isTextInput() {
        return EventQueue.getCurrentEvent() instanceof KeyEvent key
                && (key.getModifiersEx() & COMMAND_KEYS) == 0
                && key.getKeyCode() >= KeyEvent.VK_SPACE
                && (key.getKeyCode() < KeyEvent.VK_F1 || key.getKeyCode() > KeyEvent.VK_F12)
                && KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner() instanceof JTextComponent field
                && field.isEditable();
    }
}
