package org.phrenic.ui.dock;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.ScenarioStore;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;

/** Scenarios stored by name: save, restore, delete, and switch between two of them to compare. */
public final class SettingsDock extends JPanel {
    private final transient Session session;
    private final transient ScenarioStore store;
    private final transient Supplier<Optional<String>> askName;
    private final DefaultListModel<String> names = new DefaultListModel<>();
    private final JList<String> list = new JList<>(names);
    private final JComboBox<String> first = Controls.describe(new JComboBox<>(), "Settings A", "Settings A");
    private final JComboBox<String> second = Controls.describe(new JComboBox<>(), "Settings B", "Settings B");
    private final JButton swap = Controls.button(
            "Switch", "Goes to A, and with the next press to B, and so on; each can be undone", this::swap);
    private final JLabel comparisonLabel = Controls.secondaryLabel(" ");
    private final JLabel emptyLabel = Controls.secondaryLabel(
            "<html>Save... keeps all present settings under a name, to go back to them or to compare two.</html>");
    private boolean secondIsNext;

    public SettingsDock(Session session) {
        this(session, ScenarioStore.ofUser(), null);
    }

    /** @param askName asks for a name; null for a dialog */
    SettingsDock(Session session, ScenarioStore store, Supplier<Optional<String>> askName) {
        super(new BorderLayout());
        this.session = session;
        this.store = store;
        this.askName = askName == null ? this::promptName : askName;
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setVisibleRowCount(6);
        list.getAccessibleContext().setAccessibleName("Stored settings");
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                if (e.getClickCount() == 2) {
                    restore();
                }
            }
        });
        JPanel body = new JPanel(
                new MigLayout("insets 8, fillx, hidemode 3", "[grow,fill,sg b][grow,fill,sg b][grow,fill,sg b]"));
        body.add(emptyLabel, "spanx 3, wmin 0, wrap");
        body.add(new JScrollPane(list), "spanx 3, growx, growy, pushy, h 90:140:, wrap");
        body.add(Controls.button("Save...", "Store the present settings under a name", this::save));
        body.add(Controls.button("Restore", "Go to the selected settings; can be undone", this::restore));
        body.add(Controls.button("Delete", "Delete the selected settings", this::delete), "wrap");
        body.add(new JLabel("Compare two of them"), "spanx 3, gaptop 8, wrap");
        swap.setMnemonic('w');
        body.add(first, "wmin 0");
        body.add(second, "wmin 0");
        body.add(swap, "wrap");
        body.add(comparisonLabel, "spanx 3, wmin 0");
        add(body, BorderLayout.CENTER);
        refresh();
    }

    private Optional<String> promptName() {
        return Optional.ofNullable(JOptionPane.showInputDialog(
                this, "Name of the present settings", "Save settings", JOptionPane.PLAIN_MESSAGE));
    }

    void save() {
        askName.get()
                .ifPresent(name -> reportingErrors(() -> {
                    store.save(name, session.scenario());
                    refresh();
                    list.setSelectedValue(name.strip(), true);
                    session.note("Settings '" + name.strip() + "' are stored.");
                }));
    }

    void restore() {
        if (list.getSelectedValue() != null) {
            apply(list.getSelectedValue());
        }
    }

    private void delete() {
        String name = list.getSelectedValue();
        if (name != null) {
            reportingErrors(() -> {
                store.delete(name);
                refresh();
            });
        }
    }

    /** Goes to A and B in turn. */
    void swap() {
        Object name = (secondIsNext ? second : first).getSelectedItem();
        if (name != null) {
            apply((String) name);
            comparisonLabel.setText("Now " + (secondIsNext ? "B: " : "A: ") + name);
            secondIsNext = !secondIsNext;
        }
    }

    private void apply(String name) {
        reportingErrors(() -> {
            Scenario stored = store.load(name);
            EditName change = EditName.of("Settings '" + name + "'");
            // Settings that differ in live parameters alone change without reloading the scene.
            Optional<List<Assignment>> live = session.scenario().liveChangesTo(stored, "window");
            live.ifPresentOrElse(
                    changes -> session.changeSeparately(change, changes), () -> session.open(change, stored));
        });
    }

    private void reportingErrors(Runnable what) {
        try {
            what.run();
        } catch (RuntimeException failure) {
            session.refuse(failure.getMessage());
        }
    }

    private void refresh() {
        reportingErrors(() -> {
            List<String> stored = store.names();
            names.clear();
            names.addAll(stored);
            fillChoices(first, stored, 0);
            fillChoices(second, stored, 1);
            swap.setEnabled(stored.size() > 1);
            emptyLabel.setVisible(stored.isEmpty());
        });
    }

    private static void fillChoices(JComboBox<String> box, List<String> stored, int otherwise) {
        Object before = box.getSelectedItem();
        box.removeAllItems();
        stored.forEach(box::addItem);
        if (stored.contains(before)) {
            box.setSelectedItem(before);
        } else {
            box.setSelectedIndex(otherwise < stored.size() ? otherwise : -1);
        }
    }
}
