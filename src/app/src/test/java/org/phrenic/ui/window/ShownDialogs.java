package org.phrenic.ui.window;

import java.awt.Component;
import java.awt.Window;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;

/** Dialogs of the toolkit that are shown; used on the event dispatch thread. */
public final class ShownDialogs {
    private ShownDialogs() {}

    /** The dialog that chooses a file or folder. */
    public static Optional<JFileChooser> chooser() {
        return contents(JFileChooser.class).findFirst();
    }

    /** The dialog that asks or tells something. */
    public static Optional<JOptionPane> question() {
        return contents(JOptionPane.class).findFirst();
    }

    /** Answers nothing: closes the dialogs. */
    public static void close() {
        dialogs().forEach(Window::dispose);
    }

    private static Stream<JDialog> dialogs() {
        return Stream.of(Window.getWindows())
                .filter(window -> window.isShowing() && window instanceof JDialog)
                .map(JDialog.class::cast);
    }

    private static <C extends Component> Stream<C> contents(Class<C> kind) {
        return dialogs()
                .flatMap(dialog -> Stream.of(dialog.getContentPane().getComponents()))
                .filter(kind::isInstance)
                .map(kind::cast);
    }
}
