package org.phrenic.ui.dock;

import com.formdev.flatlaf.util.UIScale;
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
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.RateLimiter;
import org.phrenic.ui.widget.SliderScale;
import org.phrenic.ui.widget.TypedText;

/**
 * A number: slider, text field, unit, and a button that resets it. A value typed out of range is set to the end of the
 * range, with a message. A dragged slider sends at most twenty values per second, which are undone together.
 */
final class SliderRow extends SettingRow {
    private static final int PAGE = SliderScale.POSITIONS / 10;

    private final transient Session session;
    private final transient NumberSetting setting;
    private final String unit;
    private final transient SliderScale scale;
    private final JSlider slider = Controls.slider(0, SliderScale.POSITIONS, 0);
    private final JButton reset;
    private final transient RateLimiter rateLimiter = new RateLimiter(this::send, System::nanoTime);
    private double value = Double.NaN;
    private final JTextField field = new JTextField(NumberFormats.format(value));
    private double sentValue = Double.NaN;
    private double defaultValue = Double.NaN;
    private boolean updating;
    private boolean used = true;

    SliderRow(Session session, NumberSetting setting) {
        super(setting, setting.key());
        this.session = session;
        this.setting = setting;
        unit = setting.unit();
        double usual = Scenario.defaults().get(setting);
        if (Double.isNaN(usual)) {
            usual = Scenario.defaults().withMaterial(Materials.PAPER).get(setting);
        }
        scale = SliderScale.of(setting.minimum(), setting.maximum(), usual);
        slider.setMinimumSize(new Dimension(UIScale.scale(40), slider.getPreferredSize().height));
        slider.getAccessibleContext().setAccessibleName(setting.label());
        slider.setMajorTickSpacing(PAGE);
        slider.addChangeListener(e -> onSlide());
        field.setHorizontalAlignment(SwingConstants.RIGHT);
        TypedText.onTaken(field, this::onTyped);
        field.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent e) {
                field.selectAll();
            }
        });
        field.putClientProperty("JComponent.minimumWidth", 0);
        reset = Controls.iconButton(Icons.RESET, "Reset " + setting.label(), () -> take(defaultValue, ""));
        add(slider);
        add(field, "growx");
        add(new JLabel(unit.equals("1") ? "" : unit.replace("^2", "\u00b2")), "wmin 0");
        add(reset, "w 20!, h 22!");
        finish(field);
        slider.setToolTipText(field.getToolTipText());
    }

    private void onSlide() {
        if (updating) {
            return;
        }
        showInputMessage("");
        setShownValue(scale.valueAt(slider.getValue()));
        rateLimiter.request();
        if (!slider.getValueIsAdjusting()) {
            rateLimiter.flush();
            // The value may have been refused or undone while the slider was held.
            show(session.scenario());
        }
    }

    /** Whether a number is typed that is not taken yet. */
    private boolean isTyped() {
        return !field.getText().equals(NumberFormats.format(value));
    }

    private void onTyped() {
        if (!isTyped()) {
            return;
        }
        OptionalDouble number = NumberFormats.parse(field.getText(), unit);
        if (number.isEmpty()) {
            showInputMessage(NumberFormats.refusal(field.getText(), range(), unit));
            setShownValue(value);
            return;
        }
        double typed = number.getAsDouble();
        double taken = Math.max(scale.minimum(), Math.min(scale.maximum(), typed));
        take(taken, taken == typed ? "" : NumberFormats.outOfRange(typed, taken, unit));
    }

    /** Sets and sends a value, which is undone on its own. */
    private void take(double taken, String message) {
        showInputMessage(message);
        setShownValue(taken);
        rateLimiter.request();
        rateLimiter.flush();
        session.edits().endMerging();
    }

    private void showInputMessage(String sentence) {
        setInputMessage(sentence);
        field.putClientProperty("JComponent.outline", sentence.isEmpty() ? null : "warning");
    }

    private String range() {
        return NumberFormats.format(scale.minimum()) + " to " + NumberFormats.withUnit(scale.maximum(), unit);
    }

    private void send() {
        if (value != sentValue) {
            EditName change = EditName.of(setting.label(), sentValue, value, unit);
            sentValue = value;
            session.change(change, Assignment.of("window", setting, value));
        }
        if (!slider.getValueIsAdjusting()) {
            session.edits().endMerging();
        }
    }

    /** Shows a value in slider and field without sending it. */
    private void setShownValue(double newValue) {
        value = newValue;
        updating = true;
        if (!slider.getValueIsAdjusting() && scale.positionOf(newValue) != slider.getValue()) {
            slider.setValue(scale.positionOf(newValue));
        }
        Controls.tellValue(slider, NumberFormats.withUnit(newValue, unit));
        String text = NumberFormats.format(newValue);
        if (!text.equals(field.getText())) {
            field.setText(text);
        }
        updating = false;
        enableReset();
    }

    private void enableReset() {
        reset.setEnabled(used && value != defaultValue && !Double.isNaN(defaultValue));
    }

    /** Enables the controls; with a reason, which is shown below them, disables them. */
    void setUnused(String reason) {
        used = reason.isEmpty();
        setHint(reason, false);
        slider.setEnabled(used);
        field.setEnabled(used);
        enableReset();
    }

    @Override
    void show(Scenario scenario) {
        defaultValue = scenario.defaultOf(setting);
        String standard = NumberFormats.withUnit(defaultValue, unit);
        reset.setToolTipText("Reset to " + standard);
        setDetails(range() + ", default " + standard + "; key " + setting.key(), slider, field);
        boolean unfinished = slider.getValueIsAdjusting() || rateLimiter.isPending() || isTyped();
        if (!unfinished) {
            sentValue = scenario.get(setting);
            if (sentValue != value) {
                showInputMessage("");
            }
            setShownValue(sentValue);
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
