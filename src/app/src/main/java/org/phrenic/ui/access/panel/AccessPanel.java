package org.phrenic.ui.access.panel;

import java.awt.Insets;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;

/** A panel of the rehearsal dock: rows of controls that show the state of the rehearsal. */
abstract class AccessPanel extends JPanel implements Session.Listener, RehearsalController.Listener {
    final transient RehearsalController rehearsal;

    AccessPanel(RehearsalController rehearsal) {
        super(new MigLayout("insets 0, gap 6 4, fillx, hidemode 3, wrap 1, novisualpadding", "[grow, fill]"));
        this.rehearsal = rehearsal;
    }

    /** Shows the present state, and follows it from here on; called at the end of a constructor. */
    final void follow(Session session) {
        onState();
        session.addListener(this);
        rehearsal.addListener(this);
    }

    /** Adds components one below the other. */
    final void addAll(JComponent... components) {
        for (JComponent component : components) {
            add(component, "wmin 0");
        }
    }

    /** Controls beside each other that share the width. */
    static JPanel row(JComponent... controls) {
        JPanel row = new JPanel(new MigLayout("insets 0, gap 6, novisualpadding"));
        for (JComponent control : controls) {
            row.add(control, "growx, pushx, wmin 0");
        }
        return row;
    }

    static JButton button(String text, String tip, Runnable action) {
        return compact(new JButton(text), text, tip, action);
    }

    static JToggleButton toggle(String text, String name, String tip, Runnable action) {
        return compact(Controls.highlightWhenSelected(new JToggleButton(text)), name, tip, action);
    }

    private static <B extends AbstractButton> B compact(B button, String name, String tip, Runnable action) {
        button.setMargin(new Insets(2, 4, 2, 4));
        button.addActionListener(e -> action.run());
        return Controls.describe(button, name, tip);
    }

    static void setEnabled(boolean enabled, JComponent... controls) {
        for (JComponent control : controls) {
            control.setEnabled(enabled);
        }
    }

    final boolean isReady() {
        return rehearsal.stage() == RehearsalStage.READY;
    }
}
