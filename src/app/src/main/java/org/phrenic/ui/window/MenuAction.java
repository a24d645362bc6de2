package org.phrenic.ui.window;

import java.awt.AWTEvent;
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

/**
 * Something that can be done from a menu, with a key and perhaps from the toolbar: one object for all of them, and a
 * row of the table of keys.
 */
final class MenuAction extends AbstractAction {
    private final transient Runnable operation;

    /**
     * @param name in menus
     * @param tip in one sentence
     * @param key that does it, as {@link KeyStroke#getKeyStroke(String)} takes it; {@code menu} stands for Ctrl or the
     *     platform's own; null for none
     */
    MenuAction(String name, String tip, String key, Runnable what) {
        super(name);
        this.operation = what;
        putValue(SHORT_DESCRIPTION, tip);
        if (key != null) {
            putValue(ACCELERATOR_KEY, parseKeyStroke(key));
        }
    }

    /** With a sign for the toolbar. */
    MenuAction withIcon(Icon icon) {
        putValue(Action.LARGE_ICON_KEY, icon);
        return this;
    }

    private static KeyStroke parseKeyStroke(String key) {
        boolean menu = key.contains("menu ");
        KeyStroke plain = KeyStroke.getKeyStroke(key.replace("menu ", ""));
        return menu
                ? KeyStroke.getKeyStroke(
                        plain.getKeyCode(),
                        plain.getModifiers() | Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx())
                : plain;
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

    /** The key for people: "Ctrl+Shift+Z"; empty for none. */
    String acceleratorText() {
        KeyStroke key = accelerator();
        if (key == null) {
            return "";
        }
        String modifiers = InputEvent.getModifiersExText(key.getModifiers());
        String name = KeyEvent.getKeyText(key.getKeyCode());
        return modifiers.isEmpty() ? name : modifiers + "+" + name;
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        if (!isTextInput()) {
            operation.run();
        }
    }

    /** A letter typed into a text field is text, though the menu has it as a key too. */
    private static boolean isTextInput() {
        AWTEvent event = EventQueue.getCurrentEvent();
        return event instanceof KeyEvent key
                && (key.getModifiersEx()
                                & (InputEvent.CTRL_DOWN_MASK | InputEvent.META_DOWN_MASK | InputEvent.ALT_DOWN_MASK))
                        == 0
                && key.getKeyCode() >= KeyEvent.VK_SPACE
                && (key.getKeyCode() < KeyEvent.VK_F1 || key.getKeyCode() > KeyEvent.VK_F12)
                && KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner() instanceof JTextComponent field
                && field.isEditable();
    }
}
