package org.phrenic.ui.access.panel;

import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JToggleButton;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.simulation.live.RunHistory;
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
        addAll(bar, new ButtonRows(quiet, deep, holdAtExpiration, holdAtInspiration));
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
        rehearsal.needle().hold(on ? Optional.of(end) : Optional.empty());
        showHold();
    }

    /** Shows the hold that is asked for, here or by a key, while it waits and while it lasts. */
    private void showHold() {
        Optional<BreathEvent.Kind> held = rehearsal.needle().heldAt();
        holdAtExpiration.setSelected(held.equals(Optional.of(BreathEvent.Kind.END_EXPIRATION)));
        holdAtInspiration.setSelected(held.equals(Optional.of(BreathEvent.Kind.END_INSPIRATION)));
    }

    @Override
    public void onState() {
        setEnabled(isReady(), holdAtExpiration, holdAtInspiration);
    }

    @Override
    public void onChange() {
        boolean recorded = session.scenario().trace().isPresent();
        String preset = session.scenario().preset();
        quiet.setSelected(!recorded && preset.equals("quiet"));
        deep.setSelected(!recorded && preset.equals("deep"));
        showHold();
        bar.setPattern(session.scenario());
    }

    @Override
    public void onTick(RunStatus status) {
        showHold();
        if (isShowing()) {
            Optional.ofNullable(session.live().history())
                    .flatMap(RunHistory::latest)
                    .ifPresent(values -> bar.setPhase(values, status));
        }
    }
}
