package org.phrenic.ui.access.panel;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;

/** Buttons that share the width of one row, or of two rows where their texts would be cut in one. */
final class ButtonRows extends JPanel {
    private static final int GAP = 6;

    private final transient List<JComponent> buttons;
    private int columns;

    ButtonRows(JComponent... buttons) {
        this.buttons = List.of(buttons);
        arrange(buttons.length);
    }

    private void arrange(int beside) {
        columns = beside;
        removeAll();
        setLayout(new MigLayout("insets 0, gap " + GAP + ", fillx, novisualpadding, wrap " + columns));
        buttons.forEach(button -> add(button, "growx, pushx, wmin 0"));
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        int needed = buttons.stream()
                        .mapToInt(button -> button.getPreferredSize().width + GAP)
                        .sum()
                - GAP;
        int beside = width > 0 && width < needed ? (buttons.size() + 1) / 2 : buttons.size();
        if (beside != columns) {
            arrange(beside);
            // The height that is asked for is another.
            SwingUtilities.invokeLater(this::revalidate);
        }
    }

    /** The columns that the buttons stand in. */
    int columns() {
        return columns;
    }
}
