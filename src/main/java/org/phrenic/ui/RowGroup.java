package org.phrenic.ui;

import java.awt.Font;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.phrenic.simulation.Scenario;

/** Rows under a heading that folds them away. */
final class RowGroup extends JPanel {
    private final transient List<SettingRow> rows = new ArrayList<>();
    private final JButton heading;
    private final String label;
    private boolean open = true;
    private transient Scenario last;
    private String lastSearch = "";

    RowGroup(String label) {
        super(new MigLayout("insets 4 0 2 0, fillx, hidemode 3, gapy 0, wrap 1", "[grow,fill]"));
        this.label = label;
        heading = new JButton(label);
        heading.putClientProperty("JButton.buttonType", "borderless");
        heading.setHorizontalAlignment(SwingConstants.LEFT);
        heading.setToolTipText("Show or fold away: " + label);
        heading.addActionListener(e -> {
            open = !open;
            show(null, "");
        });
        add(heading);
        name();
        setOpaque(false);
    }

    private void name() {
        heading.setText((open ? "\u25be  " : "\u25b8  ") + label);
        heading.setFont(heading.getFont().deriveFont(Font.BOLD));
    }

    void addRow(SettingRow row) {
        rows.add(row);
        add(row);
    }

    List<SettingRow> rows() {
        return rows;
    }

    /** Shows the values of a scenario in the rows that it has and a search finds; while something is searched for nothing is folded away. */
    void show(Scenario scenario, String search) {
        if (scenario != null) {
            last = scenario;
            lastSearch = search;
        }
        if (last == null) {
            return;
        }
        boolean searching = !lastSearch.isBlank();
        boolean any = false;
        for (SettingRow row : rows) {
            boolean there = row.applies(last) && row.matches(lastSearch);
            if (there) {
                row.show(last);
            }
            any |= there;
            row.setVisible(there && (searching || open));
        }
        name();
        setVisible(any);
    }
}
