package org.phrenic.ui.access.panel;

import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JToggleButton;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.access.plan.NeedleState;
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

    /** The end of a phase at which the breath is held, or will be. */
    private transient Optional<BreathEvent.Kind> held = Optional.empty();
    /** Time of the run at which a hold was last asked for or released here, s. */
    private double askedS = Double.NaN;

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
        held = on ? Optional.of(end) : Optional.empty();
        askedS = rehearsal.state().map(NeedleState::timeS).orElse(Double.NaN);
        rehearsal.needle().hold(held);
        showHold();
    }

    /**
     * The end of a phase at which the breath is held, or will be; empty if it is neither, or is held elsewhere.
     *
     * @param pending event that a hold waits for, as text; empty for none
     * @param holds whether the breath is held
     * @param before the end shown before
     */
    static Optional<BreathEvent.Kind> endOfHold(String pending, boolean holds, Optional<BreathEvent.Kind> before) {
        if (!pending.isEmpty()) {
            return Optional.of(BreathEvent.parse(pending).kind());
        }
        return holds ? before : Optional.empty();
    }

    private void showHold() {
        holdAtExpiration.setSelected(held.equals(Optional.of(BreathEvent.Kind.END_EXPIRATION)));
        holdAtInspiration.setSelected(held.equals(Optional.of(BreathEvent.Kind.END_INSPIRATION)));
    }

    /** Follows holds that are asked for by keys and in plans; what was asked for here is in a later state. */
    private void followHold() {
        Optional<NeedleState> state = rehearsal.state();
        if (state.filter(s -> s.timeS() == askedS).isEmpty()) {
            held = endOfHold(
                    state.map(NeedleState::pendingHold).orElse(""),
                    session.scenario().hold(),
                    held);
            showHold();
        }
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
        followHold();
        bar.setPattern(session.scenario());
    }

    @Override
    public void onTick(RunStatus status) {
        followHold();
        if (isShowing()) {
            Optional.ofNullable(session.live().history())
                    .flatMap(RunHistory::latest)
                    .ifPresent(values -> bar.setPhase(values, status));
        }
    }
}
