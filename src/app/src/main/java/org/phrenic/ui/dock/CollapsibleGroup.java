package org.phrenic.ui.dock;

import java.awt.Font;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.phrenic.scenario.Scenario;

/** Rows under a heading that collapses them. */
final class CollapsibleGroup extends JPanel {
    private final transient List<SettingRow> rows = new ArrayList<>();
    private final JButton heading;
    private final String label;
    private boolean expanded = true;
    private transient Scenario shownScenario;
    private String shownSearch = "";

    CollapsibleGroup(String label) {
        super(new MigLayout("insets 4 0 2 0, fillx, hidemode 3, gapy 0, wrap 1", "[grow,fill]"));
        this.label = label;
        heading = new JButton(label);
        heading.putClientProperty("JButton.buttonType", "borderless");
        heading.setHorizontalAlignment(SwingConstants.LEFT);
        heading.setToolTipText("Expand or collapse: " + label);
        heading.addActionListener(e -> {
            // What is found by a search is shown in any case.
            if (shownSearch.isBlank()) {
                expanded = !expanded;
                show(null, "");
            }
        });
        add(heading);
        updateHeading();
        setOpaque(false);
    }

    private void updateHeading() {
        heading.setText((isOpen() ? "\u25be  " : "\u25b8  ") + label);
        heading.setFont(heading.getFont().deriveFont(Font.BOLD));
    }

    private boolean isOpen() {
        return expanded || !shownSearch.isBlank();
    }

    void addRow(SettingRow row) {
        rows.add(row);
        add(row);
    }

    List<SettingRow> rows() {
        return rows;
    }

    /** Shows the rows that apply to a scenario and match a search, with its values; a search expands the group. */
    void show(Scenario scenario, String search) {
        if (scenario != null) {
            shownScenario = scenario;
            shownSearch = search;
        }
        if (shownScenario == null) {
            return;
        }
        List<SettingRow> matching = rows.stream()
                .filter(row -> row.applies(shownScenario) && row.matches(shownSearch))
                .toList();
        matching.forEach(row -> row.show(shownScenario));
        rows.forEach(row -> row.setVisible(isOpen() && matching.contains(row)));
        updateHeading();
        setVisible(!matching.isEmpty());
    }
}
