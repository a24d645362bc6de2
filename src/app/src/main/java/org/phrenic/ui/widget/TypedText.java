package org.phrenic.ui.widget;

import java.awt.Component;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Objects;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;

/** What is typed into a field is taken at Enter, when the field is left within its window, and before a command. */
public final class TypedText {
    private static final String TAKEN_BY = "phrenic.takenBy";

    private TypedText() {}

    /** Lets {@code take} read what is typed into a field. */
    public static void onTaken(JTextField field, Runnable take) {
        field.putClientProperty(TAKEN_BY, take);
        field.addActionListener(e -> take.run());
        field.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent e) {
                // Another window is looked at, in the midst of a number perhaps. A menu has the focus for a while too.
                if (!e.isTemporary() || isInWindowOf(field, e.getOppositeComponent())) {
                    take.run();
                }
            }
        });
    }

    private static boolean isInWindowOf(Component field, Component other) {
        return other != null && Objects.equals(SwingUtilities.getRoot(field), SwingUtilities.getRoot(other));
    }

    /**
     * Takes what is typed into a field.
     *
     * @param focused the part that has the focus, which may be another; null for none
     */
    public static void take(Component focused) {
        if (focused instanceof JTextField field && field.getClientProperty(TAKEN_BY) instanceof Runnable take) {
            take.run();
        }
    }
}
