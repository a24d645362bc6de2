package org.phrenic.ui.access.panel;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.chart.PhaseBar;
import org.phrenic.ui.chart.PhaseColours;
import org.phrenic.ui.dock.BreathDock;
import org.phrenic.ui.session.Session;

/** Where in the breath the body is, and how it is asked to breathe: quietly, deeply, not at all. */
final class BreathPanel extends JPanel implements Session.Listener, RehearsalListener {
    private static final int PHASE = Observation.COLUMNS.indexOf("phase");

    private final transient Session session;
    private final transient RehearsalController door;
    private final transient Consumer<String> presetSelector;
    private final PhaseBar bar = new PhaseBar();
    private final JToggleButton quiet = new JToggleButton("Quiet");
    private final JToggleButton deep = new JToggleButton("Deep");
    private final JToggleButton holdAtExpiration = new JToggleButton("Hold at exp.");
    private final JToggleButton holdAtInspiration = new JToggleButton("Hold at insp.");

    /** @param breathing told by which preset to breathe */
    BreathPanel(Session session, RehearsalController door, Consumer<String> breathing) {
        super(PanelRows.columnLayout());
        this.session = session;
        this.door = door;
        this.presetSelector = breathing;
        add(bar);
        PanelRows.describe(quiet, "Breathe quietly", "Quiet breathing (Q)");
        PanelRows.describe(deep, "Breathe deeply", "Deep breathing (D)");
        PanelRows.describe(
                holdAtExpiration,
                "Hold at expiration",
                "Hold the breath when air has flowed out; press again to breathe on (H)");
        PanelRows.describe(
                holdAtInspiration,
                "Hold at inspiration",
                "Hold the breath when it is drawn in; press again to breathe on");
        quiet.addActionListener(e -> selectPreset("quiet"));
        deep.addActionListener(e -> selectPreset("deep"));
        holdAtExpiration.addActionListener(e -> hold(holdAtExpiration, BreathEvent.Kind.END_EXPIRATION));
        holdAtInspiration.addActionListener(e -> hold(holdAtInspiration, BreathEvent.Kind.END_INSPIRATION));
        add(PanelRows.row(quiet, deep, holdAtExpiration, holdAtInspiration), "wmin 0");
        onChange();
        onState();
        session.addListener(this);
        door.addListener(this);
    }

    private void selectPreset(String preset) {
        presetSelector.accept(preset);
        onChange();
    }

    private void hold(JToggleButton button, BreathEvent.Kind end) {
        for (JToggleButton other : List.of(holdAtExpiration, holdAtInspiration)) {
            other.setSelected(other == button && button.isSelected());
        }
        door.needle().hold(button.isSelected() ? Optional.of(end) : Optional.empty());
    }

    @Override
    public void onState() {
        boolean ready = door.stage() == RehearsalStage.READY;
        holdAtExpiration.setEnabled(ready);
        holdAtInspiration.setEnabled(ready);
    }

    @Override
    public void onChange() {
        String preset = session.scenario().preset();
        quiet.setSelected(preset.equals("quiet"));
        deep.setSelected(preset.equals("deep"));
        if (!session.scenario().hold()
                && door.state().map(s -> s.pendingHold().isEmpty()).orElse(true)) {
            holdAtInspiration.setSelected(false);
            holdAtExpiration.setSelected(false);
        }
        BreathDock.showPhaseFractions(bar, session.scenario());
    }

    @Override
    public void onTick(RunStatus status) {
        RunHistory history = session.live().history();
        if (isShowing() && history != null && history.size() > 0) {
            bar.setPhase(history.values(history.size() - 1)[PHASE], PhaseColours.parseLabel(status.phaseLabel()));
        }
    }
}
