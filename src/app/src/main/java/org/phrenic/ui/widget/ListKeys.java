package org.phrenic.ui.widget;

import java.awt.event.ActionEvent;
import java.util.List;
import javax.accessibility.Accessible;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.ComboBoxModel;
import javax.swing.JComboBox;
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
            goTo(box, key, model);
            return -1;
        });
        return box;
    }

    /** Goes on to the next entry of the list that begins with a letter. */
    private static void goTo(JComboBox<?> box, char key, ComboBoxModel<?> model) {
        Accessible popup = box.getUI().getAccessibleChild(box, 0);
        if (!box.isShowing() || !(popup instanceof ComboPopup shown)) {
            return;
        }
        box.setPopupVisible(true);
        JList<?> list = shown.getList();
        int size = model.getSize();
        for (int i = 1; i <= size; i++) {
            int index = (list.getSelectedIndex() + i) % size;
            String text = String.valueOf(model.getElementAt(index));
            if (!text.isEmpty() && Character.toLowerCase(text.charAt(0)) == Character.toLowerCase(key)) {
                list.setSelectedIndex(index);
                list.ensureIndexIsVisible(index);
                return;
            }
        }
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
