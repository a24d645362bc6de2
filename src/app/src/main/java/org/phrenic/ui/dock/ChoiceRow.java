package org.phrenic.ui.dock;

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
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Scenario;

/** A choice among names. One that cannot be changed while the scene runs says that the scene starts anew. */
final class ChoiceRow extends SettingRow {
    private final transient Setting<?> choice;
    private final JComboBox<String> comboBox = new JComboBox<>();
    private final transient Predicate<Scenario> applies;
    private String shownValue = "";
    private boolean updating;

    /**
     * @param options to choose from, as a scenario has them
     * @param chosen told the old and the new value
     */
    ChoiceRow(Setting<?> choice, List<String> options, Predicate<Scenario> applies, BiConsumer<String, String> chosen) {
        super(choice.key(), choice.label(), tip(choice.description(), details(choice)));
        this.choice = choice;
        this.applies = applies;
        comboBox.setModel(new DefaultComboBoxModel<>(options.toArray(String[]::new)));
        comboBox.setRenderer(new OptionRenderer());
        comboBox.setPrototypeDisplayValue("backward-euler");
        comboBox.addActionListener(e -> {
            String now = (String) comboBox.getSelectedItem();
            if (!updating && !now.equals(shownValue)) {
                String before = shownValue;
                shownValue = now;
                chosen.accept(before, now);
            }
        });
        add(comboBox, "spanx 4, growx, wmin 60, wmax 240");
        finish(comboBox, choice.label());
    }

    private static String details(Setting<?> choice) {
        return (choice.isLive() ? "changes while it breathes" : "starts the scene anew") + "; key " + choice.key();
    }

    Setting<?> choice() {
        return choice;
    }

    JComboBox<String> comboBox() {
        return comboBox;
    }

    @Override
    void show(Scenario scenario) {
        shownValue = scenario.text(choice);
        updating = true;
        List<String> options = new ArrayList<>();
        for (int i = 0; i < comboBox.getItemCount(); i++) {
            options.add(comboBox.getItemAt(i));
        }
        if (!options.contains(shownValue)) {
            comboBox.addItem(shownValue);
        }
        comboBox.setSelectedItem(shownValue);
        updating = false;
    }

    @Override
    boolean applies(Scenario scenario) {
        return applies.test(scenario);
    }

    @Override
    boolean isOffDefault(Scenario scenario) {
        return !scenario.text(choice).equals(Scenario.defaults().text(choice));
    }

    /** The name of an option for people: a folder by its own name, {@code backward-euler} as {@code Backward Euler}. */
    static String displayName(String option) {
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

    private static final class OptionRenderer extends DefaultListCellRenderer {
        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            JLabel label = (JLabel) super.getListCellRendererComponent(list, value, index, selected, focused);
            label.setText(displayName(String.valueOf(value)));
            return label;
        }
    }
}
