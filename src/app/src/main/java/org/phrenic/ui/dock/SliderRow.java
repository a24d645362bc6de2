package org.phrenic.ui.dock;

import java.awt.Dimension;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.OptionalDouble;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.SwingConstants;
import org.phrenic.model.material.Materials;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.RateLimiter;
import org.phrenic.ui.widget.SliderScale;

/**
 * A number: slider, typed value with its unit, and a button back to the default. What is typed beyond the range is set
 * to its end, and said so. While the slider is dragged the value goes out at most twenty times a second, and all of it
 * is one change to undo.
 */
final class SliderRow extends SettingRow {
    private static final int PAGE = SliderScale.POSITIONS / 10;

    private final transient Session session;
    private final transient NumberSetting setting;
    private final String name;
    private final String unit;
    private final transient SliderScale scale;
    private final JSlider slider = new JSlider(0, SliderScale.POSITIONS);
    private final JTextField field = new JTextField();
    private final JButton reset = new JButton(Icons.RESET);
    private final transient RateLimiter throttle = new RateLimiter(this::send, System::nanoTime);
    private double value = Double.NaN;
    private double sent = Double.NaN;
    private double byDefault = Double.NaN;
    private boolean showing;

    SliderRow(Session session, NumberSetting setting) {
        super(setting.key(), setting.label(), tip(setting.description(), setting.key()));
        this.session = session;
        this.setting = setting;
        name = setting.label();
        unit = setting.unit();
        double physical = Scenario.defaults().get(setting);
        double usual = Double.isNaN(physical)
                ? Scenario.defaults().withMaterial(Materials.PAPER).get(setting)
                : physical;
        scale = SliderScale.of(setting.minimum(), setting.maximum(), usual);
        slider.setMinimumSize(new Dimension(40, slider.getPreferredSize().height));
        slider.getAccessibleContext().setAccessibleName(name);
        slider.setMajorTickSpacing(PAGE);
        slider.addChangeListener(e -> slid());
        field.setHorizontalAlignment(SwingConstants.RIGHT);
        field.addActionListener(e -> typed());
        field.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent e) {
                field.selectAll();
            }

            @Override
            public void focusLost(FocusEvent e) {
                typed();
            }
        });
        reset.putClientProperty("JButton.buttonType", "toolBarButton");
        reset.getAccessibleContext().setAccessibleName("Reset " + name);
        reset.setToolTipText("Reset " + name);
        reset.addActionListener(e -> toDefault());
        add(slider);
        field.putClientProperty("JComponent.minimumWidth", 0);
        add(field, "growx");
        add(new JLabel(unit.equals("1") ? "" : unit.replace("^2", "\u00b2")), "wmin 0");
        add(reset, "w 20!, h 22!");
        finish(field, name);
        slider.setToolTipText(field.getToolTipText());
    }

    private void slid() {
        if (showing) {
            return;
        }
        answered("");
        set(scale.valueAt(slider.getValue()));
        throttle.request();
        if (!slider.getValueIsAdjusting()) {
            throttle.flush();
        }
    }

    /** Takes what stands in the field. */
    private void typed() {
        if (field.getText().equals(NumberFormats.format(value))) {
            return;
        }
        OptionalDouble number = NumberFormats.parse(field.getText());
        if (number.isEmpty()) {
            answered("Found '" + field.getText() + "', expected a number from " + range() + ".");
            set(value);
            return;
        }
        double wanted = number.getAsDouble();
        double taken = Math.max(scale.minimum(), Math.min(scale.maximum(), wanted));
        answered(
                taken == wanted
                        ? ""
                        : NumberFormats.withUnit(wanted, unit) + " is out of range; "
                                + (taken < wanted ? "the largest, " : "the smallest, ")
                                + NumberFormats.withUnit(taken, unit) + ", is taken.");
        set(taken);
        throttle.request();
        throttle.flush();
        session.edits().endMerging();
    }

    /** Says what became of what was typed, until the value is another. */
    private void answered(String sentence) {
        answer(sentence);
        field.putClientProperty("JComponent.outline", sentence.isEmpty() ? null : "warning");
    }

    private String range() {
        return NumberFormats.format(scale.minimum()) + " to " + NumberFormats.withUnit(scale.maximum(), unit);
    }

    private void toDefault() {
        answered("");
        set(byDefault);
        throttle.request();
        throttle.flush();
        session.edits().endMerging();
    }

    private void send() {
        if (value != sent) {
            EditName change = EditName.of(name, sent, value, unit);
            sent = value;
            session.change(change, Assignment.of("window", setting, value));
        }
        if (!slider.getValueIsAdjusting()) {
            session.edits().endMerging();
        }
    }

    /** Puts a value into slider and field, and sends nothing. */
    private void set(double newValue) {
        value = newValue;
        showing = true;
        if (!slider.getValueIsAdjusting() && scale.positionOf(newValue) != slider.getValue()) {
            slider.setValue(scale.positionOf(newValue));
        }
        String text = NumberFormats.format(newValue);
        if (!text.equals(field.getText())) {
            field.setText(text);
        }
        showing = false;
        reset.setEnabled(value != byDefault && !Double.isNaN(byDefault));
    }

    @Override
    void show(Scenario scenario) {
        byDefault = scenario.defaultOf(setting);
        String standard = "default " + NumberFormats.withUnit(byDefault, unit);
        reset.setToolTipText("Reset to " + NumberFormats.withUnit(byDefault, unit));
        setTip(tip(setting.description(), range() + ", " + standard + "; key " + setting.key()), slider, field);
        boolean unfinished = slider.getValueIsAdjusting()
                || throttle.isPending()
                || (field.hasFocus() && !field.getText().equals(NumberFormats.format(value)));
        if (!unfinished) {
            sent = scenario.get(setting);
            if (sent != value) {
                answered("");
            }
            set(sent);
        }
    }

    @Override
    boolean applies(Scenario scenario) {
        return !Double.isNaN(scenario.get(setting));
    }

    @Override
    boolean isOffDefault(Scenario scenario) {
        return !scenario.get(setting).equals(scenario.defaultOf(setting));
    }

    JSlider slider() {
        return slider;
    }

    JTextField field() {
        return field;
    }

    JButton resetButton() {
        return reset;
    }
}
