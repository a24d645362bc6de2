package org.phrenic.ui.dock;

import java.awt.Insets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.chart.PhaseBar;
import org.phrenic.ui.chart.PhaseColours;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.LatestTask;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.FileDialogs;
import org.phrenic.ui.widget.Icons;

/**
 * The breathing pattern: presets, hold, rate, depth, inspiratory fraction, chest share, a recorded trace, and the
 * present phase.
 */
public final class BreathDock extends SessionDock {
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final List<Parameter> PRESET_PARAMETERS =
            List.of(Breathing.RATE, Breathing.INSPIRATORY_FRACTION, Breathing.CHEST_SHARE);
    private static final List<Parameter> REPLACED_BY_TRACE = List.of(Breathing.RATE, Breathing.INSPIRATORY_FRACTION);

    /** So that two columns fit into a narrow dock. */
    private static final Insets BUTTON_MARGIN = new Insets(2, 4, 2, 4);

    private final PhaseBar bar = new PhaseBar();
    private final JLabel breath = Controls.secondaryLabel(" ");
    private final transient Map<String, JToggleButton> presets = new LinkedHashMap<>();
    private final ButtonGroup presetGroup = new ButtonGroup();
    private final JToggleButton hold = new JToggleButton("Hold now");
    private final JLabel trace = new JLabel("Breath by preset");
    private final JLabel traceDescription = Controls.secondaryLabel("");
    private transient Optional<Path> describedTrace = Optional.empty();
    /** Whether the trace may have been written anew since it was described. */
    private boolean describeAnew;

    private final transient LatestTask describing = new LatestTask();
    private final JButton removeTrace =
            Controls.iconButton(Icons.CLOSE, "Remove the recorded trace", this::removeTrace);
    private final transient List<SliderRow> rows;

    public BreathDock(Session session) {
        super(session);
        body.add(phasePanel(), "wmin 0");
        body.add(presetButtons(), "wmin 0");
        rows = Stream.of(Breathing.RATE, Breathing.DEPTH, Breathing.INSPIRATORY_FRACTION, Breathing.CHEST_SHARE)
                .map(parameter -> new SliderRow(session, parameter))
                .toList();
        rows.forEach(body::add);
        body.add(trace(), "wmin 0");
        follow();
    }

    private JComponent phasePanel() {
        JPanel panel = new JPanel(new MigLayout("insets 8 8 2 8, fillx, wrap 1", "[grow,fill]"));
        panel.add(bar);
        panel.add(breath);
        return panel;
    }

    private JComponent presetButtons() {
        JPanel panel = new JPanel(new MigLayout("insets 2 8 6 8, fillx, wrap 2", "[grow,fill,sg][grow,fill,sg]"));
        for (String name : BreathingPreset.names()) {
            JToggleButton button = Controls.highlightWhenSelected(new JToggleButton(ChoiceRow.displayName(name)));
            button.setToolTipText("Breathe by the preset '" + name + "'; changes while it breathes");
            button.addActionListener(e -> selectPreset(name));
            presetGroup.add(button);
            presets.put(name, button);
            button.setMargin(BUTTON_MARGIN);
            panel.add(button, "wmin 0");
        }
        Controls.highlightWhenSelected(hold);
        hold.setToolTipText("Hold the breath where it is, or let it go on");
        // The Help menu has H.
        hold.setMnemonic('o');
        hold.addActionListener(e -> session.change(
                hold.isSelected() ? "Hold of the breath" : "End of the hold",
                Assignment.of("window", Breathing.HOLD, hold.isSelected())));
        hold.setMargin(BUTTON_MARGIN);
        panel.add(hold, "wmin 0");
        return panel;
    }

    private JComponent trace() {
        JPanel panel = new JPanel(new MigLayout("insets 6 8 4 6, fillx, hidemode 3", "[][grow,fill,0::][]"));
        JButton open = Controls.button(
                "Trace from CSV...",
                "Breathe as recorded: a CSV file with columns time_s,amplitude, or of a skin marker",
                () -> FileDialogs.open(this, "Recorded breathing", "csv").ifPresent(this::openTrace));
        removeTrace.setToolTipText("Back to the breathing preset; reloads the scene");
        panel.add(open);
        panel.add(trace, "wmin 0");
        panel.add(removeTrace, "wrap");
        traceDescription.setVisible(false);
        panel.add(traceDescription, "spanx 3, growx, wmin 0");
        return panel;
    }

    /** Changes the breathing preset; rate, inspiratory fraction and chest share go to those of the preset. */
    public void selectPreset(String name) {
        session.opening().drop();
        Scenario scenario = session.userScenario();
        if (isBreathOf(scenario, name) && !scenario.hold()) {
            return;
        }
        Scenario next = scenario.with("preset=" + name);
        List<Assignment> list = new ArrayList<>();
        list.add(Assignment.of("window", Breathing.PRESET, next.breathing()));
        if (scenario.hold()) {
            list.add(Assignment.of("window", Breathing.HOLD, false));
        }
        for (Parameter parameter : PRESET_PARAMETERS) {
            if (scenario.states(parameter)) {
                list.add(Assignment.of("window", parameter, next.defaultOf(parameter)));
            }
        }
        String before = ChoiceRow.displayName(scenario.preset());
        EditName change = new EditName("Breathing", before, ChoiceRow.displayName(name));
        if (scenario.trace().isPresent()) {
            session.open(change, scenario.without(Breathing.TRACE).changed(list));
        } else {
            session.changeSeparately(change, list);
        }
    }

    /** Whether a body breathes by a preset as that is, held or not. */
    public static boolean isBreathOf(Scenario scenario, String preset) {
        return scenario.preset().equals(preset)
                && scenario.trace().isEmpty()
                && PRESET_PARAMETERS.stream().allMatch(p -> scenario.get(p).equals(scenario.defaultOf(p)));
    }

    private void removeTrace() {
        session.open(
                EditName.of("End of the recorded breath"),
                session.userScenario().without(Breathing.TRACE));
    }

    /** Breathes by a recorded trace; a file that is none is refused with a message. */
    void openTrace(Path file) {
        String place = file.toAbsolutePath().toString();
        // A recording of hours takes seconds to read; what is chosen meanwhile counts.
        session.opening()
                .execute(
                        () -> Assignment.read("window", Breathing.TRACE.key(), place),
                        read -> {
                            describeAnew = true;
                            session.change("Breath recorded in " + file.getFileName(), read);
                        },
                        session::refuse);
    }

    @Override
    public void onScene(LiveScene scene) {
        // It has read its recording anew.
        describeAnew = true;
        super.onScene(scene);
    }

    @Override
    public void onChange() {
        Scenario scenario = session.scenario();
        JToggleButton preset = presets.get(scenario.preset());
        if (scenario.trace().isEmpty() && preset != null) {
            preset.setSelected(true);
        } else {
            presetGroup.clearSelection();
        }
        hold.setSelected(scenario.hold());
        rows.forEach(row -> row.show(scenario));
        Optional<Path> file = scenario.trace();
        trace.setText(file.map(f -> f.getFileName().toString()).orElse("Breath by preset"));
        trace.setToolTipText(file.map(Path::toString).orElse("No recorded breath"));
        removeTrace.setVisible(file.isPresent());
        describeTrace(scenario, file);
        bar.setPattern(scenario);
    }

    /** Says what was read of another trace, and disables what a trace replaces. */
    private void describeTrace(Scenario scenario, Optional<Path> file) {
        String reason = file.isEmpty() ? "" : "Not used: the recorded breath has its own.";
        rows.stream()
                .filter(row -> REPLACED_BY_TRACE.stream().anyMatch(parameter -> row.isFor(parameter.key())))
                .forEach(row -> row.setUnused(reason));
        if (!describeAnew && file.equals(describedTrace)) {
            return;
        }
        describeAnew = false;
        describedTrace = file;
        describing.execute(
                () -> Breathing.traceDescription(scenario).orElse(""), this::showDescription, this::showDescription);
    }

    private void showDescription(String sentence) {
        traceDescription.setText("<html>" + Controls.escapeHtml(sentence) + "</html>");
        traceDescription.setVisible(!sentence.isEmpty());
    }

    JLabel traceDescription() {
        return traceDescription;
    }

    SliderRow row(Parameter parameter) {
        return rows.stream()
                .filter(row -> row.isFor(parameter.key()))
                .findFirst()
                .orElseThrow();
    }

    @Override
    public void onTick(RunStatus status) {
        Optional.ofNullable(session.live().history())
                .flatMap(RunHistory::latest)
                .ifPresent(values -> show(values, status));
    }

    private void show(double[] values, RunStatus status) {
        bar.setPhase(values, status);
        int number = (int) (values[BREATH] + 1);
        breath.setText("Breath " + number + ", "
                + PhaseColours.parseLabel(status.phaseLabel()).label());
    }

    JToggleButton presetButton(String name) {
        return presets.get(name);
    }

    JToggleButton holdButton() {
        return hold;
    }
}
