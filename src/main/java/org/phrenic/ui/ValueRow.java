package org.phrenic.ui;

import java.awt.Dimension;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.SwingConstants;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Choice;
import org.phrenic.simulation.Material;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;

/**
 * A number: slider, typed value with its unit, and a button back to the default. What is typed beyond the range is set to its end, and said so. While the slider is dragged the value goes out at most twenty times
 * a second, and all of it is one change to undo.
 */
final class ValueRow extends SettingRow {
    private static final int PAGE = SliderScale.PLACES / 10;

    private final transient Session session;
    private final String key;
    private final String name;
    private final String unit;
    private final String meaning;
    private final transient SliderScale scale;
    private final transient ToDoubleFunction<Scenario> valueOf;
    private final transient ToDoubleFunction<Scenario> defaultOf;
    private final JSlider slider = new JSlider(0, SliderScale.PLACES);
    private final JTextField field = new JTextField();
    private final JButton reset = new JButton(Icons.RESET);
    private final transient Throttle throttle = new Throttle(this::send, System::nanoTime);
    private double value = Double.NaN;
    private double sent = Double.NaN;
    private double byDefault = Double.NaN;
    private boolean showing;

    /** A row for a tunable number. */
    static ValueRow of(Session session, Parameter p) {
        double physical = p.defaultFor(Material.PHYSICAL);
        double usual = Double.isNaN(physical) ? p.defaultFor(Material.PAPER) : physical;
        return new ValueRow(
                session,
                p.key(),
                p.label(),
                p.unit(),
                SliderScale.of(p.minimum(), p.maximum(), usual),
                p.meaning(),
                scenario -> Settings.value(scenario, p),
                scenario -> Settings.defaultOf(scenario, p));
    }

    /** A row for a choice that is a number. */
    static ValueRow of(Session session, Choice c, ToDoubleFunction<Scenario> defaultOf) {
        return new ValueRow(
                session,
                c.key(),
                c.label(),
                c.unit(),
                SliderScale.of(c.minimum(), c.maximum(), Double.NaN),
                c.meaning(),
                scenario -> Double.parseDouble(c.of(scenario)),
                defaultOf);
    }

    private ValueRow(
            Session session,
            String key,
            String name,
            String unit,
            SliderScale scale,
            String meaning,
            ToDoubleFunction<Scenario> valueOf,
            ToDoubleFunction<Scenario> defaultOf) {
        super(key, name, tip(meaning, key));
        this.session = session;
        this.key = key;
        this.name = name;
        this.unit = unit;
        this.scale = scale;
        this.meaning = meaning;
        this.valueOf = valueOf;
        this.defaultOf = defaultOf;
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
        set(scale.value(slider.getValue()));
        throttle.request();
        if (!slider.getValueIsAdjusting()) {
            throttle.flush();
        }
    }

    /** Takes what stands in the field. */
    private void typed() {
        if (field.getText().equals(Figures.text(value))) {
            return;
        }
        OptionalDouble number = Figures.parse(field.getText());
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
                        : Figures.withUnit(wanted, unit) + " is out of range; "
                                + (taken < wanted ? "the largest, " : "the smallest, ")
                                + Figures.withUnit(taken, unit) + ", is taken.");
        set(taken);
        throttle.request();
        throttle.flush();
        session.edits().close();
    }

    /** Says what became of what was typed, until the value is another. */
    private void answered(String sentence) {
        answer(sentence);
        field.putClientProperty("JComponent.outline", sentence.isEmpty() ? null : "warning");
    }

    private String range() {
        return Figures.text(scale.minimum()) + " to " + Figures.withUnit(scale.maximum(), unit);
    }

    private void toDefault() {
        answered("");
        set(byDefault);
        throttle.request();
        throttle.flush();
        session.edits().close();
    }

    private void send() {
        if (value != sent) {
            String change = Settings.changeName(name, sent, value, unit);
            sent = value;
            session.change(change, new Assignment("window", key, Settings.plain(value)));
        }
        if (!slider.getValueIsAdjusting()) {
            session.edits().close();
        }
    }

    /** Puts a value into slider and field, and sends nothing. */
    private void set(double newValue) {
        value = newValue;
        showing = true;
        if (!slider.getValueIsAdjusting() && scale.place(newValue) != slider.getValue()) {
            slider.setValue(scale.place(newValue));
        }
        String text = Figures.text(newValue);
        if (!text.equals(field.getText())) {
            field.setText(text);
        }
        showing = false;
        reset.setEnabled(value != byDefault && !Double.isNaN(byDefault));
    }

    @Override
    void show(Scenario scenario) {
        byDefault = defaultOf.applyAsDouble(scenario);
        String standard = "default " + Figures.withUnit(byDefault, unit);
        reset.setToolTipText("Reset to " + Figures.withUnit(byDefault, unit));
        setTip(tip(meaning, range() + ", " + standard + "; key " + key), slider, field);
        boolean unfinished = slider.getValueIsAdjusting()
                || throttle.isPending()
                || (field.hasFocus() && !field.getText().equals(Figures.text(value)));
        if (!unfinished) {
            sent = valueOf.applyAsDouble(scenario);
            if (sent != value) {
                answered("");
            }
            set(sent);
        }
    }

    @Override
    boolean applies(Scenario scenario) {
        return !Double.isNaN(valueOf.applyAsDouble(scenario));
    }

    @Override
    boolean isOffDefault(Scenario scenario) {
        return valueOf.applyAsDouble(scenario) != defaultOf.applyAsDouble(scenario);
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
