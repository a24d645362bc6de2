package org.phrenic.ui.dock;

import java.util.List;
import java.util.function.BiConsumer;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JComboBox;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.ListKeys;

/** A choice among options. */
final class ChoiceRow extends SettingRow {
    private final transient Setting<?> choice;
    private final JComboBox<String> comboBox = new JComboBox<>();
    private String shownValue = "";
    private boolean updating;

    /**
     * @param options values as in a scenario
     * @param chosen gets the old and the new value
     */
    ChoiceRow(Setting<?> choice, List<String> options, BiConsumer<String, String> chosen) {
        super(choice, details(choice));
        this.choice = choice;
        comboBox.setModel(new DefaultComboBoxModel<>(options.toArray(String[]::new)));
        comboBox.setRenderer(Controls.renderer(option -> displayName(String.valueOf(option))));
        ListKeys.chooseByEnter(comboBox);
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
        finish(comboBox);
    }

    private static String details(Setting<?> choice) {
        return (choice.isLive() ? "changes while it breathes" : "reloads the scene") + "; key " + choice.key();
    }

    JComboBox<String> comboBox() {
        return comboBox;
    }

    @Override
    void show(Scenario scenario) {
        shownValue = scenario.text(choice);
        updating = true;
        if (((DefaultComboBoxModel<String>) comboBox.getModel()).getIndexOf(shownValue) < 0) {
            comboBox.addItem(shownValue);
        }
        comboBox.setSelectedItem(shownValue);
        updating = false;
    }

    @Override
    boolean isOffDefault(Scenario scenario) {
        return !scenario.text(choice).equals(Scenario.defaults().text(choice));
    }

    /** The display name of an option: a folder by its own name, {@code backward-euler} as {@code Backward Euler}. */
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
            default -> Controls.capitalise(option).replace('-', ' ');
        };
    }
}
