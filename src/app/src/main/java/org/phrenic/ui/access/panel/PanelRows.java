package org.phrenic.ui.access.panel;

import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.dock.BreathDock;

/** How the sections of the clinician's dock are laid out, and their controls named. */
final class PanelRows {
    private PanelRows() {}

    /** A section: one thing under the other. */
    static MigLayout columnLayout() {
        return new MigLayout("insets 0, gap 6 4, fillx, hidemode 3, wrap 1, novisualpadding", "[grow, fill]");
    }

    /** Controls beside each other that share the width. */
    static JPanel row(JComponent... controls) {
        JPanel row = new JPanel(new MigLayout("insets 0, gap 6, novisualpadding"));
        for (JComponent control : controls) {
            row.add(control, "growx, pushx, wmin 0");
        }
        return row;
    }

    /** Names a control for people, screen readers and tests. */
    static void describe(JComponent control, String name, String tip) {
        control.setName(name);
        control.getAccessibleContext().setAccessibleName(name);
        control.setToolTipText(tip);
        if (control instanceof AbstractButton button) {
            button.setMargin(new java.awt.Insets(2, 4, 2, 4));
            if (button instanceof JToggleButton toggle) {
                BreathDock.highlightWhenSelected(toggle);
            }
        }
    }
}
