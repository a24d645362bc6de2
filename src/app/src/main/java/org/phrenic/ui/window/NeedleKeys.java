package org.phrenic.ui.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.InputMap;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.ScrollablePanel;

/**
 * Lets the keys of needle and probe be used from the docks: arrow keys act before a scroll pane or tabs take them, and
 * a choice from a list gives the focus back to the view. While the actions are off, the docks are as any other.
 */
final class NeedleKeys {
    private static final String ADDED = "phrenic.needleKeys";

    private final List<MenuAction> actions;
    private final JComponent view;

    NeedleKeys(List<MenuAction> actions, JComponent view) {
        this.actions = actions.stream().filter(NeedleKeys::isArrow).toList();
        this.view = view;
    }

    private static boolean isArrow(MenuAction action) {
        return action.accelerator() != null
                && action.accelerator().getKeyCode() >= KeyEvent.VK_LEFT
                && action.accelerator().getKeyCode() <= KeyEvent.VK_DOWN;
    }

    /** Adds a part of the window with all within it; what is added already stays as it is. */
    void add(Component part) {
        if (part instanceof JComponent own && own.getClientProperty(ADDED) == null) {
            own.putClientProperty(ADDED, true);
            if (own instanceof ScrollablePanel) {
                bind(own);
            } else if (own instanceof JTabbedPane tabs) {
                bindTabs(tabs);
            } else if (own instanceof JComboBox<?> box) {
                Controls.onListClosed(box, this::returnFocus);
            }
        }
        if (part instanceof Container container) {
            for (Component child : container.getComponents()) {
                add(child);
            }
        }
    }

    private void bind(JComponent panel) {
        for (MenuAction action : actions) {
            panel.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(action.accelerator(), action.name());
            panel.getActionMap().put(action.name(), action);
        }
    }

    /** Lets the actions act before the tabs take their keys; while an action is off, the tabs have its key. */
    private void bindTabs(JTabbedPane tabs) {
        InputMap keys = tabs.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
        for (MenuAction action : actions) {
            Object ofTabs = keys.get(action.accelerator());
            keys.put(action.accelerator(), action.name());
            tabs.getActionMap().put(action.name(), ofTabs == null ? action : new FirstOfTwo(action, tabs, ofTabs));
        }
    }

    /** An action, and while it is off another one of a component. */
    private static final class FirstOfTwo extends AbstractAction {
        private final transient MenuAction first;
        private final JComponent component;
        private final transient Object second;

        FirstOfTwo(MenuAction first, JComponent component, Object second) {
            this.first = first;
            this.component = component;
            this.second = second;
        }

        @Override
        public void actionPerformed(ActionEvent e) {
            Action other = component.getActionMap().get(second);
            if (first.isEnabled()) {
                first.actionPerformed(e);
            } else if (other != null) {
                other.actionPerformed(e);
            }
        }
    }

    private void returnFocus() {
        if (actions.stream().anyMatch(MenuAction::isEnabled)) {
            view.requestFocusInWindow();
        }
    }
}
