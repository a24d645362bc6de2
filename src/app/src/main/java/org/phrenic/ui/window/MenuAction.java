package org.phrenic.ui.window;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.function.BooleanSupplier;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.Icon;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import org.phrenic.ui.widget.TypedText;

/** An action with a menu item, perhaps an accelerator key and a button of the tool bar. */
final class MenuAction extends AbstractAction {
    private static final int COMMAND_KEYS =
            InputEvent.CTRL_DOWN_MASK | InputEvent.META_DOWN_MASK | InputEvent.ALT_DOWN_MASK;

    private final transient Runnable operation;
    private transient BooleanSupplier state = () -> false;

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

    /** With a state that its item in a menu shows. */
    MenuAction withState(BooleanSupplier shown) {
        state = shown;
        return this;
    }

    /** Lets the items of the action show its present state. */
    void showState() {
        putValue(Action.SELECTED_KEY, state.getAsBoolean());
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

    /** Does it, whatever has the focus. */
    void run() {
        operation.run();
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        boolean typed = EventQueue.getCurrentEvent() instanceof KeyEvent key && isTyped(key, focus.getFocusOwner());
        if (!typed) {
            TypedText.take(focus.getPermanentFocusOwner());
            operation.run();
        }
    }

    /**
     * Whether a key is a character that a text field takes, or that a list, a table or a box of choices may select by,
     * though the character is an accelerator too.
     *
     * @param focused part that has the focus; null for none
     */
    static boolean isTyped(KeyEvent key, Component focused) {
        return (key.getModifiersEx() & COMMAND_KEYS) == 0
                && key.getKeyCode() >= KeyEvent.VK_SPACE
                && (key.getKeyCode() < KeyEvent.VK_F1 || key.getKeyCode() > KeyEvent.VK_F12)
                && takesCharacters(focused);
    }

    private static boolean takesCharacters(Component focused) {
        return (focused instanceof JTextComponent field && field.isEditable())
                || focused instanceof JList
                || focused instanceof JComboBox
                || focused instanceof JTable;
    }
}
