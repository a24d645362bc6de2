package org.phrenic.ui;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import org.phrenic.rehearsal.BreathEvent;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.live.History;
import org.phrenic.simulation.live.Status;

/** Where in the breath the body is, and how it is asked to breathe: quietly, deeply, not at all. */
final class BreathSection extends JPanel implements Session.Events, DoorEvents {
    private static final int PHASE = Observation.COLUMNS.indexOf("phase");

    private final transient Session session;
    private final transient RehearsalDoor door;
    private final transient Consumer<String> breathing;
    private final PhaseBar bar = new PhaseBar();
    private final JToggleButton quiet = new JToggleButton("Quiet");
    private final JToggleButton deep = new JToggleButton("Deep");
    private final JToggleButton holdOut = new JToggleButton("Hold at exp.");
    private final JToggleButton holdIn = new JToggleButton("Hold at insp.");

    /** @param breathing told by which preset to breathe */
    BreathSection(Session session, RehearsalDoor door, Consumer<String> breathing) {
        super(ClinicRow.section());
        this.session = session;
        this.door = door;
        this.breathing = breathing;
        add(bar);
        ClinicRow.named(quiet, "Breathe quietly", "Quiet breathing (Q)");
        ClinicRow.named(deep, "Breathe deeply", "Deep breathing (D)");
        ClinicRow.named(
                holdOut,
                "Hold at expiration",
                "Hold the breath when air has flowed out; press again to breathe on (H)");
        ClinicRow.named(
                holdIn, "Hold at inspiration", "Hold the breath when it is drawn in; press again to breathe on");
        quiet.addActionListener(e -> breathe("quiet"));
        deep.addActionListener(e -> breathe("deep"));
        holdOut.addActionListener(e -> hold(holdOut, BreathEvent.Kind.END_EXPIRATION));
        holdIn.addActionListener(e -> hold(holdIn, BreathEvent.Kind.END_INSPIRATION));
        add(ClinicRow.of(quiet, deep, holdOut, holdIn), "wmin 0");
        onChange();
        onDoor();
        session.listen(this);
        door.listen(this);
    }

    private void breathe(String preset) {
        breathing.accept(preset);
        onChange();
    }

    private void hold(JToggleButton button, BreathEvent.Kind end) {
        for (JToggleButton other : List.of(holdOut, holdIn)) {
            other.setSelected(other == button && button.isSelected());
        }
        door.hand().hold(button.isSelected() ? Optional.of(end) : Optional.empty());
    }

    @Override
    public void onDoor() {
        boolean ready = door.stage() == DoorStage.READY;
        holdOut.setEnabled(ready);
        holdIn.setEnabled(ready);
    }

    @Override
    public void onChange() {
        String preset = session.scenario().preset();
        quiet.setSelected(preset.equals("quiet"));
        deep.setSelected(preset.equals("deep"));
        if (!session.scenario().hold()
                && door.state().map(s -> s.waitsFor().isEmpty()).orElse(true)) {
            holdIn.setSelected(false);
            holdOut.setSelected(false);
        }
        BreathDock.shares(bar, session.scenario());
    }

    @Override
    public void onTick(Status status) {
        History history = session.live().history();
        if (isShowing() && history != null && history.size() > 0) {
            bar.setPhase(history.values(history.size() - 1)[PHASE], PhaseColours.label(status.phaseLabel()));
        }
    }
}
