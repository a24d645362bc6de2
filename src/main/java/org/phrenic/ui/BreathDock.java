package org.phrenic.ui;

import java.awt.BorderLayout;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPreset;
import org.phrenic.breathing.TraceFile;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Choice;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.History;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/** How it breathes: presets by a press, hold where it is, rate, depth and balance, a recorded breath, and a bar that shows where in the breath it is. */
public final class BreathDock extends JPanel implements Session.Events {
    private static final int PHASE = Observation.COLUMNS.indexOf("phase");
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final List<Parameter> FROM_PRESET =
            List.of(Parameter.RATE, Parameter.INSPIRATORY_FRACTION, Parameter.CHEST_SHARE);
    /** Presets whose breaths are inspiration, expiration and pause alone. */
    private static final List<String> PLAIN = List.of("quiet", "quiet-supine", "deep", "sniff", "rapid-shallow");

    private final transient Session session;
    private final PhaseBar bar = new PhaseBar();
    private final JLabel breath = new JLabel(" ");
    private final transient Map<String, JToggleButton> presets = new LinkedHashMap<>();
    private final ButtonGroup group = new ButtonGroup();
    private final JToggleButton hold = new JToggleButton("Hold now");
    private final JLabel trace = new JLabel("Breath by preset");
    private final JButton dropTrace = new JButton(Icons.CLOSE);
    private final transient List<ValueRow> rows = new ArrayList<>();

    public BreathDock(Session session) {
        super(new BorderLayout());
        this.session = session;
        JPanel body = new DockBody();
        body.add(phase());
        body.add(buttons());
        for (Parameter p :
                List.of(Parameter.RATE, Parameter.DEPTH, Parameter.INSPIRATORY_FRACTION, Parameter.CHEST_SHARE)) {
            ValueRow row = ValueRow.of(session, p);
            rows.add(row);
            body.add(row);
        }
        body.add(trace());
        add(DockBody.scroll(body), BorderLayout.CENTER);
        onChange();
        session.listen(this);
    }

    private JComponent phase() {
        JPanel panel = new JPanel(new MigLayout("insets 8 8 2 8, fillx, wrap 1", "[grow,fill]"));
        breath.setForeground(Theme.quietText());
        panel.add(bar);
        panel.add(breath);
        return panel;
    }

    private JComponent buttons() {
        JPanel panel = new JPanel(new MigLayout("insets 2 8 6 8, fillx, wrap 2", "[grow,fill,sg][grow,fill,sg]"));
        for (String name : BreathingPreset.names()) {
            JToggleButton button = marked(new JToggleButton(ChoiceRow.nameOf(name)));
            button.setToolTipText("Breathe by the preset '" + name + "'; changes while it breathes");
            button.addActionListener(e -> choose(name));
            group.add(button);
            presets.put(name, button);
            panel.add(button);
        }
        marked(hold);
        hold.setToolTipText("Hold the breath where it is, or let it go on");
        hold.setMnemonic('H');
        hold.addActionListener(e -> session.change(
                hold.isSelected() ? "Hold of the breath" : "End of the hold",
                new Assignment("window", "hold", String.valueOf(hold.isSelected()))));
        panel.add(hold);
        return panel;
    }

    /** A pressed button stands out as a selected row of a list does. */
    static JToggleButton marked(JToggleButton button) {
        button.putClientProperty(
                "FlatLaf.style",
                "selectedBackground: $List.selectionBackground; selectedForeground: $List.selectionForeground");
        return button;
    }

    private JComponent trace() {
        JPanel panel = new JPanel(new MigLayout("insets 6 8 4 6, fillx, hidemode 3", "[][grow,fill,0::][]"));
        JButton open = new JButton("Trace from CSV...");
        open.setToolTipText("Breathe as recorded: a CSV file with columns time_s,amplitude, or of a skin marker");
        open.addActionListener(
                e -> Choosers.open(this, "Recorded breathing", "csv").ifPresent(this::openTrace));
        dropTrace.setToolTipText("Leave the recorded breath for the preset's; starts the scene anew");
        dropTrace.getAccessibleContext().setAccessibleName("Leave the recorded breath");
        dropTrace.putClientProperty("JButton.buttonType", "toolBarButton");
        dropTrace.addActionListener(
                e -> session.open("End of the recorded breath", Settings.withoutTrace(session.scenario())));
        panel.add(open);
        panel.add(trace, "wmin 0");
        panel.add(dropTrace);
        return panel;
    }

    /** Breathes by a preset. Rate, fraction and balance that were set by hand go to those of the preset: who presses Deep wants its deep breath. */
    void choose(String name) {
        Scenario scenario = session.scenario();
        if (scenario.preset().equals(name)
                && !scenario.hold()
                && scenario.trace().isEmpty()) {
            return;
        }
        Scenario next = scenario.with("preset=" + name);
        List<Assignment> list = new ArrayList<>();
        list.add(new Assignment("window", Choice.PRESET.key(), name));
        if (scenario.hold()) {
            list.add(new Assignment("window", "hold", "false"));
        }
        for (Parameter parameter : FROM_PRESET) {
            if (scenario.isSet(parameter)) {
                list.add(Settings.assignment(parameter, Settings.defaultOf(next, parameter)));
            }
        }
        String change = Settings.changeName("Breathing", ChoiceRow.nameOf(scenario.preset()), ChoiceRow.nameOf(name));
        session.edits().close();
        if (scenario.trace().isPresent()) {
            session.open(change, Settings.withoutTrace(scenario).with(list));
        } else {
            session.change(change, list.toArray(Assignment[]::new));
        }
        session.edits().close();
    }

    /** Breathes by a recording; one that is none is refused in one sentence. */
    void openTrace(Path file) {
        try {
            TraceFile.read(file);
            session.change(
                    "Breath recorded in " + file.getFileName(),
                    new Assignment("window", "trace", file.toAbsolutePath().toString()));
        } catch (IOException e) {
            session.say(Session.Message.Kind.REFUSED, e.getMessage());
        }
    }

    @Override
    public void onScene(LiveScene scene) {
        onChange();
    }

    @Override
    public void onChange() {
        Scenario scenario = session.scenario();
        JToggleButton preset = presets.get(scenario.preset());
        if (scenario.trace().isEmpty() && preset != null) {
            preset.setSelected(true);
        } else {
            group.clearSelection();
        }
        hold.setSelected(scenario.hold());
        rows.forEach(row -> row.show(scenario));
        Optional<Path> file = scenario.trace();
        trace.setText(file.map(f -> f.getFileName().toString()).orElse("Breath by preset"));
        trace.setToolTipText(file.map(Path::toString).orElse("No recorded breath"));
        dropTrace.setVisible(file.isPresent());
        shares(bar, scenario);
    }

    /** Gives a bar the shares of the breath that a scenario has. */
    static void shares(PhaseBar bar, Scenario scenario) {
        BreathingParameters p = scenario.breathing().parameters();
        bar.setShares(
                Settings.value(scenario, Parameter.INSPIRATORY_FRACTION),
                p.pauseFraction(),
                scenario.trace().isEmpty() && PLAIN.contains(scenario.preset()));
    }

    @Override
    public void onTick(Status status) {
        History history = session.live().history();
        if (history == null || history.size() == 0) {
            return;
        }
        double[] now = history.values(history.size() - 1);
        bar.setPhase(now[PHASE], PhaseColours.label(status.phaseLabel()));
        breath.setText("Breath " + (int) (now[BREATH] + 1) + ", "
                + PhaseColours.name(PhaseColours.label(status.phaseLabel())).toLowerCase(Locale.ROOT));
    }

    JToggleButton presetButton(String name) {
        return presets.get(name);
    }

    JToggleButton holdButton() {
        return hold;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (breath != null) {
            breath.setForeground(Theme.quietText());
        }
    }
}
