package org.phrenic.ui.access.panel;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JToggleButton;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.chart.PhaseBar;
import org.phrenic.ui.session.Session;

/** The phase of the breath, and buttons for quiet breathing, deep breathing and breath holds. */
final class BreathPanel extends AccessPanel {
    private final transient Session session;
    private final transient Consumer<String> presetSelector;
    private final PhaseBar bar = new PhaseBar();
    private final JToggleButton quiet =
            toggle("Quiet", "Breathe quietly", "Quiet breathing (Q)", () -> selectPreset("quiet"));
    private final JToggleButton deep =
            toggle("Deep", "Breathe deeply", "Deep breathing (D)", () -> selectPreset("deep"));
    private final JToggleButton holdAtExpiration = toggle(
            "Hold at exp.",
            "Hold at expiration",
            "Hold the breath at end-expiration; press again to breathe on (H)",
            () -> hold(BreathEvent.Kind.END_EXPIRATION));
    private final JToggleButton holdAtInspiration = toggle(
            "Hold at insp.",
            "Hold at inspiration",
            "Hold the breath at end-inspiration; press again to breathe on",
            () -> hold(BreathEvent.Kind.END_INSPIRATION));

    /** @param presetSelector changes the breathing preset */
    BreathPanel(Session session, RehearsalController rehearsal, Consumer<String> presetSelector) {
        super(rehearsal);
        this.session = session;
        this.presetSelector = presetSelector;
        addAll(bar, row(quiet, deep, holdAtExpiration, holdAtInspiration));
        onChange();
        follow(session);
    }

    private void selectPreset(String preset) {
        presetSelector.accept(preset);
        onChange();
    }

    private void hold(BreathEvent.Kind end) {
        boolean atExpiration = end == BreathEvent.Kind.END_EXPIRATION;
        boolean on = (atExpiration ? holdAtExpiration : holdAtInspiration).isSelected();
        (atExpiration ? holdAtInspiration : holdAtExpiration).setSelected(false);
        rehearsal.needle().hold(on ? Optional.of(end) : Optional.empty());
    }

    @Override
    public void onState() {
        setEnabled(isReady(), holdAtExpiration, holdAtInspiration);
    }

    @Override
    public void onChange() {
        String preset = session.scenario().preset();
        quiet.setSelected(preset.equals("quiet"));
        deep.setSelected(preset.equals("deep"));
        boolean waits =
                rehearsal.state().filter(s -> !s.pendingHold().isEmpty()).isPresent();
        if (!session.scenario().hold() && !waits) {
            List.of(holdAtInspiration, holdAtExpiration).forEach(button -> button.setSelected(false));
        }
        bar.setPattern(session.scenario());
    }

    @Override
    public void onTick(RunStatus status) {
        if (isShowing()) {
            bar.setPhase(session.live().history(), status);
        }
    }
}
