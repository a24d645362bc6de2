package org.phrenic.ui.widget;

import java.awt.Component;
import java.awt.event.ActionEvent;
import java.util.List;
import javax.accessibility.Accessible;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.plaf.basic.ComboPopup;

/**
 * Keys of a box of choices each of which is dear: arrow keys and letters open its list and go through it, Enter
 * chooses, Escape goes back. {@link Theme} sets what keys do while a list is open.
 */
public final class ListKeys {
    private static final List<String> MOVES = List.of(
            "selectNext",
            "selectNext2",
            "selectPrevious",
            "selectPrevious2",
            "pageDownPassThrough",
            "pageUpPassThrough",
            "homePassThrough",
            "endPassThrough");

    private ListKeys() {}

    public static <B extends JComboBox<?>> B chooseByEnter(B box) {
        MOVES.forEach(move -> box.getActionMap().put(move, new Move(box, move)));
        box.setKeySelectionManager((key, model) -> {
            goTo(box, key);
            return -1;
        });
        return box;
    }

    /** Goes on to the next entry of the list that begins with a letter. */
    private static void goTo(JComboBox<?> box, char key) {
        Accessible popup = box.getUI().getAccessibleChild(box, 0);
        if (!box.isShowing() || !(popup instanceof ComboPopup shown)) {
            return;
        }
        box.setPopupVisible(true);
        JList<?> list = shown.getList();
        int next = next(box, list.getSelectedIndex(), key);
        if (next >= 0) {
            list.setSelectedIndex(next);
            list.ensureIndexIsVisible(next);
        }
    }

    /** The next entry after another one that is shown with a letter at its beginning; -1 without one. */
    static int next(JComboBox<?> box, int after, char key) {
        int size = box.getItemCount();
        for (int i = 1; i <= size; i++) {
            int index = (after + i) % size;
            String text = shownText(box, index);
            if (!text.isEmpty() && Character.toLowerCase(text.charAt(0)) == Character.toLowerCase(key)) {
                return index;
            }
        }
        return -1;
    }

    /** The text that an entry has in the list: an entry may be stored otherwise than it is shown. */
    private static <T> String shownText(JComboBox<T> box, int index) {
        T entry = box.getItemAt(index);
        // A list of the model of the box would stay among those whom the model tells of changes.
        Component shown = box.getRenderer().getListCellRendererComponent(new JList<>(), entry, index, false, false);
        return shown instanceof JLabel label ? String.valueOf(label.getText()) : String.valueOf(entry);
    }

    /** Opens the list where it is closed, and else moves within it as usual. */
    private static final class Move extends AbstractAction {
        private final JComboBox<?> box;

        Move(JComboBox<?> box, String name) {
            super(name);
            this.box = box;
        }

        @Override
        public void actionPerformed(ActionEvent e) {
            Action usual = box.getActionMap().getParent().get(getValue(NAME));
            if (box.isPopupVisible() && usual != null) {
                usual.actionPerformed(e);
            } else if (box.isShowing()) {
                box.setPopupVisible(true);
            }
        }
    }
}
