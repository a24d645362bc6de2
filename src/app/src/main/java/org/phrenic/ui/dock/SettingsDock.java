package org.phrenic.ui.dock;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JCheckBox;
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
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.chart.BreathComparison;
import org.phrenic.ui.chart.PlotDock;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.ScenarioStore;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;
import org.phrenic.ui.widget.ScrollablePanel;

/**
 * Scenarios stored by name: save, restore, delete, and switch between two of them to compare. The last whole breath of
 * the settings that are left stays in the plot as an overlay, and a table compares it with the present breath.
 */
public final class SettingsDock extends JPanel implements Session.Listener {
    private final transient Session session;
    private final transient ScenarioStore store;
    private final transient Supplier<Optional<String>> askName;
    private final transient Predicate<String> confirms;
    private final PlotDock plots;
    private final DefaultListModel<String> names = new DefaultListModel<>();
    /** The name that was typed last, as long as nothing is stored under it. */
    private String refusedName = "";

    private final JList<String> list = new JList<>(names);
    private final JComboBox<String> first = Controls.describe(new JComboBox<>(), "Settings A", "Settings A");
    private final JComboBox<String> second = Controls.describe(new JComboBox<>(), "Settings B", "Settings B");
    private final JButton swap = Controls.button(
            "Switch", "Goes to A, and with the next press to B, and so on; each can be undone", this::swap);
    private final JLabel comparisonLabel = Controls.secondaryLabel(" ");
    private final JLabel emptyLabel = Controls.secondaryLabel(
            "<html>Save... keeps all present settings under a name, to go back to them or to compare two.</html>");
    private final JCheckBox overlay = new JCheckBox("Keep the last breath in the plot", true);
    private final JLabel table = new JLabel();
    private boolean secondIsNext;
    /** Settings that the last press went to; empty before the first. */
    private String present = "";
    /** Their values; null before the first. */
    private transient Scenario wentTo;

    /** @param plots where the breath of the settings that are left stays as an overlay */
    public SettingsDock(Session session, PlotDock plots) {
        this(session, ScenarioStore.ofUser(), null, null, plots);
    }

    /**
     * @param askName asks for a name; null for a dialog
     * @param confirms whether a question is answered by yes; null for a dialog
     */
    SettingsDock(
            Session session,
            ScenarioStore store,
            Supplier<Optional<String>> askName,
            Predicate<String> confirms,
            PlotDock plots) {
        super(new BorderLayout());
        this.session = session;
        this.store = store;
        this.plots = plots;
        this.askName = askName == null ? this::promptName : askName;
        this.confirms = confirms == null ? question -> Dialogs.confirm(this, "Settings", question) : confirms;
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
        JPanel body = new ScrollablePanel(
                new MigLayout("insets 8, fillx, hidemode 3", "[grow,fill,sg b][grow,fill,sg b][grow,fill,sg b]"));
        body.add(emptyLabel, "spanx 3, wmin 0, wrap");
        body.add(new JScrollPane(list), "spanx 3, growx, growy, pushy, h 90:140:, wrap");
        body.add(Controls.button("Save...", "Store the present settings under a name", this::save));
        JButton restore = Controls.button("Restore", "Go to the selected settings; can be undone", this::restore);
        JButton delete = Controls.button("Delete", "Delete the selected settings", this::delete);
        body.add(restore);
        body.add(delete, "wrap");
        list.addListSelectionListener(e -> {
            restore.setEnabled(!list.isSelectionEmpty());
            delete.setEnabled(!list.isSelectionEmpty());
        });
        restore.setEnabled(false);
        delete.setEnabled(false);
        body.add(new JLabel("Compare two of them"), "spanx 3, gaptop 8, wrap");
        swap.setMnemonic('w');
        body.add(first, "wmin 0");
        body.add(second, "wmin 0");
        body.add(swap, "wrap");
        body.add(comparisonLabel, "spanx 3, wmin 0, wrap");
        overlay.setToolTipText(
                "Draws the last whole breath of the settings that are left in thin dashes, and compares");
        overlay.addActionListener(e -> onOverlay());
        body.add(overlay, "spanx 3, wrap");
        table.setVisible(false);
        body.add(table, "spanx 3, wmin 0");
        add(ScrollablePanel.scrollPane(body), BorderLayout.CENTER);
        refresh();
        session.addListener(this);
    }

    private Optional<String> promptName() {
        Object typed = JOptionPane.showInputDialog(
                this,
                "Name of the present settings",
                "Save settings",
                JOptionPane.PLAIN_MESSAGE,
                null,
                null,
                refusedName);
        return Optional.ofNullable((String) typed);
    }

    void save() {
        askName.get()
                .map(String::strip)
                .ifPresent(name -> reportingErrors(() -> {
                    refusedName = name;
                    if (!store.contains(name)
                            || confirms.test("Replace the settings '" + name + "', which are stored already?")) {
                        store.save(name, session.userScenario());
                        refusedName = "";
                        refresh();
                        list.setSelectedValue(name, true);
                        session.note("Settings '" + name + "' are stored.");
                    }
                }));
    }

    void restore() {
        String name = list.getSelectedValue();
        if (name != null) {
            load(name).ifPresent(stored -> apply(name, stored));
        }
    }

    void delete() {
        String name = list.getSelectedValue();
        if (name != null && confirms.test("Delete the settings '" + name + "'? This cannot be undone.")) {
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
            load((String) name).ifPresent(stored -> swapTo((String) name, stored));
        }
    }

    private void swapTo(String name, Scenario stored) {
        String left = isAsSwitched() ? present : "the settings before";
        boolean kept = overlay.isSelected() && plots.keepBreath(left);
        boolean none = overlay.isSelected() && !kept;
        apply(name, stored);
        present = (secondIsNext ? "B: " : "A: ") + name;
        wentTo = stored;
        String sentence = "Now " + present + (none ? "; no whole breath of " + left + " to keep" : "");
        comparisonLabel.setText("<html>" + Controls.escapeHtml(sentence) + "</html>");
        secondIsNext = !secondIsNext;
        showTable();
    }

    /** Whether the present values are those that the last press went to. */
    private boolean isAsSwitched() {
        return wentTo != null
                && Assignment.liveChanges(session.userScenario(), wentTo, "window")
                        .filter(List::isEmpty)
                        .isPresent();
    }

    @Override
    public void onChange() {
        if (wentTo != null && !isAsSwitched()) {
            wentTo = null;
            comparisonLabel.setText(" ");
        }
    }

    private void onOverlay() {
        if (!overlay.isSelected()) {
            plots.removeOverlay();
        }
        showTable();
    }

    @Override
    public void onTick(RunStatus status) {
        if (isShowing()) {
            showTable();
        }
    }

    private void showTable() {
        Optional<BreathComparison> comparison = plots.comparison();
        String text = comparison.map(BreathComparison::html).orElse("");
        if (!text.equals(table.getText())) {
            table.setText(text);
            table.setVisible(!text.isEmpty());
        }
    }

    JComboBox<String> firstChoice() {
        return first;
    }

    /** What is said of the settings compared. */
    String comparison() {
        return comparisonLabel.getText();
    }

    JComboBox<String> secondChoice() {
        return second;
    }

    /** Settings that are stored; empty, with a message, if they cannot be read. */
    private Optional<Scenario> load(String name) {
        try {
            return Optional.of(store.load(name));
        } catch (RuntimeException failure) {
            session.refuse(failure.getMessage());
            return Optional.empty();
        }
    }

    private void apply(String name, Scenario stored) {
        reportingErrors(() -> {
            EditName change = EditName.of("Settings '" + name + "'");
            // Settings that differ in live parameters alone change without reloading the scene.
            Optional<List<Assignment>> live = Assignment.liveChanges(session.scenario(), stored, "window");
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
            fillChoices(first, stored, null);
            fillChoices(second, stored, first.getSelectedItem());
            swap.setEnabled(stored.size() > 1);
            emptyLabel.setVisible(stored.isEmpty());
        });
    }

    /** Offers the stored names; a selection stays, else the first name other than {@code taken} is selected. */
    private static void fillChoices(JComboBox<String> box, List<String> stored, Object taken) {
        Object before = box.getSelectedItem();
        box.removeAllItems();
        stored.forEach(box::addItem);
        boolean stays = before != null && !before.equals(taken) && stored.contains(before);
        Optional<String> other =
                stored.stream().filter(name -> !name.equals(taken)).findFirst();
        box.setSelectedItem(stays ? before : other.orElse(null));
    }
}
