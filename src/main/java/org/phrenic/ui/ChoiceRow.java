package org.phrenic.ui;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import org.phrenic.simulation.Choice;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;

/** A choice among names. One that cannot be changed while the scene runs says that the scene starts anew. */
final class ChoiceRow extends SettingRow {
    private final transient Choice choice;
    private final JComboBox<String> box = new JComboBox<>();
    private final transient Predicate<Scenario> applies;
    private String shown = "";
    private boolean showing;

    /**
     * @param options to choose from, as a scenario has them
     * @param chosen told the old and the new value
     */
    ChoiceRow(Choice choice, List<String> options, Predicate<Scenario> applies, BiConsumer<String, String> chosen) {
        super(choice.key(), choice.label(), tip(choice.meaning(), details(choice)));
        this.choice = choice;
        this.applies = applies;
        box.setModel(new DefaultComboBoxModel<>(options.toArray(String[]::new)));
        box.setRenderer(new Names());
        box.setPrototypeDisplayValue("backward-euler");
        box.addActionListener(e -> {
            String now = (String) box.getSelectedItem();
            if (!showing && !now.equals(shown)) {
                String before = shown;
                shown = now;
                chosen.accept(before, now);
            }
        });
        add(box, "spanx 4, growx, wmin 60, wmax 240");
        finish(box, choice.label());
    }

    private static String details(Choice choice) {
        return (Simulation.isLive(choice.key()) ? "changes while it breathes" : "starts the scene anew") + "; key "
                + choice.key();
    }

    Choice choice() {
        return choice;
    }

    JComboBox<String> box() {
        return box;
    }

    @Override
    void show(Scenario scenario) {
        shown = choice.of(scenario);
        showing = true;
        List<String> options = new ArrayList<>();
        for (int i = 0; i < box.getItemCount(); i++) {
            options.add(box.getItemAt(i));
        }
        if (!options.contains(shown)) {
            box.addItem(shown);
        }
        box.setSelectedItem(shown);
        showing = false;
    }

    @Override
    boolean applies(Scenario scenario) {
        return applies.test(scenario);
    }

    @Override
    boolean isOffDefault(Scenario scenario) {
        return !choice.of(scenario).equals(choice.of(Scenario.defaults()));
    }

    /** The name of an option for people: a folder by its own name, {@code backward-euler} as {@code Backward Euler}. */
    static String nameOf(String option) {
        if (option.startsWith("virtual/")) {
            return "Virtual " + option.substring("virtual/".length()).replace('-', ' ');
        }
        if (option.indexOf('/') >= 0 || option.indexOf('\\') >= 0) {
            return option.substring(Math.max(option.lastIndexOf('/'), option.lastIndexOf('\\')) + 1);
        }
        return switch (option) {
            case "rk2" -> "Midpoint Runge-Kutta (rk2)";
            case "rk4" -> "Classical Runge-Kutta (rk4)";
            case "verlet" -> "Velocity Verlet";
            case "stormer" -> "Störmer";
            case "symplectic-euler" -> "Symplectic Euler";
            case "backward-euler" -> "Backward Euler";
            case "lagged" -> "Lagged (the paper's eq. 6)";
            case "cheyne-stokes" -> "Cheyne-Stokes";
            case "hold-expiration" -> "Hold at expiration";
            case "hold-inspiration" -> "Hold at inspiration";
            default ->
                option.substring(0, 1).toUpperCase(Locale.ROOT)
                        + option.substring(1).replace('-', ' ');
        };
    }

    private static final class Names extends DefaultListCellRenderer {
        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            JLabel label = (JLabel) super.getListCellRendererComponent(list, value, index, selected, focused);
            label.setText(nameOf(String.valueOf(value)));
            return label;
        }
    }
}
