package org.phrenic.ui;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.PathAdvice;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.simulation.live.Status;
import org.phrenic.ui.clinic.Legend;
import org.phrenic.ui.clinic.Verdict;

/** Where the needle goes in, and in words what is to be said of that way over the breath and at this moment. */
final class WayInSection extends JPanel implements Session.Events, DoorEvents {
    private final transient RehearsalDoor door;
    private final JToggleButton setEntry = new JToggleButton("Set entry");
    private final JButton best = new JButton("Best path");
    private final JButton bestOut = new JButton("Best at expiration");
    private final Verdict overBreath = new Verdict();
    private final Verdict now = new Verdict();
    private final Legend legend = new Legend();

    WayInSection(Session session, RehearsalDoor door) {
        super(ClinicRow.section());
        this.door = door;
        ClinicRow.named(setEntry, "Set entry", "Then click on the skin where the needle goes in (E)");
        ClinicRow.named(best, "Best path", "The entry that is free longest, with room, on the shortest way (B)");
        ClinicRow.named(bestOut, "Best at expiration", "The best entry for a breath held at the end of expiration");
        setEntry.addActionListener(e -> door.clicks().choose(ClickChoice.Of.ENTRY));
        best.addActionListener(e -> door.way().enterAtBest(false));
        bestOut.addActionListener(e -> door.way().enterAtBest(true));
        add(ClinicRow.of(setEntry, best, bestOut), "wmin 0");
        add(legend);
        add(overBreath, "wmin 0");
        add(now, "wmin 0");
        onDoor();
        session.listen(this);
        door.listen(this);
    }

    @Override
    public void onDoor() {
        boolean ready = door.stage() == DoorStage.READY;
        setEntry.setSelected(door.clicks().choosing() == ClickChoice.Of.ENTRY);
        for (JComponent control : new JComponent[] {setEntry, best, bestOut}) {
            control.setEnabled(ready);
        }
        legend();
        advised();
        sayNow();
    }

    private void legend() {
        Optional<TargetStudy> study = door.study();
        if (study.isPresent()) {
            Map<String, Object> counts = study.get().map().counts();
            legend.show(percent(counts, "free"), percent(counts, "in_part"));
        } else {
            legend.show(-1, -1);
        }
    }

    private static long percent(Map<String, Object> counts, String key) {
        int reach = Math.max(1, (Integer) counts.get("in_reach"));
        return Math.round(100.0 * (Integer) counts.get(key) / reach);
    }

    private void advised() {
        Optional<PathAdvice> advice = door.way().advice();
        overBreath.setVisible(advice.isPresent());
        advice.ifPresent(a -> {
            StringBuilder rest = new StringBuilder(a.way());
            a.reasons().forEach(reason -> rest.append("\n").append(sentence(reason)));
            if (!a.margin().isEmpty()) {
                rest.append("\nMargin ").append(a.margin());
            }
            overBreath.say(a.level(), a.headline(), rest.toString());
        });
    }

    private static String sentence(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    @Override
    public void onTick(Status status) {
        if (isShowing()) {
            sayNow();
        }
    }

    private void sayNow() {
        Optional<NeedleState> state = door.state().filter(NeedleState::hasNeedle);
        now.setVisible(state.isPresent());
        state.ifPresent(this::sayNow);
    }

    private void sayNow(NeedleState state) {
        if (!state.warnings().isEmpty()) {
            now.say(PathAdvice.Level.BARRED, "Now: " + String.join("; ", state.warnings()), "");
        } else if (!state.reasons().isEmpty()) {
            now.say(PathAdvice.Level.BARRED, "Now barred: " + String.join("; ", state.reasons()), "");
        } else {
            String margin = state.nearest().isEmpty()
                    ? "nothing near"
                    : String.format(Locale.ROOT, "%.1f mm from %s", state.marginMm(), state.nearest());
            PathAdvice.Level level =
                    state.marginMm() < Rehearsal.ROOM_MM ? PathAdvice.Level.CAREFUL : PathAdvice.Level.FREE;
            now.say(level, "Now free: " + margin, "");
        }
    }
}
