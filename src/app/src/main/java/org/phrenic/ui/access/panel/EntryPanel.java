package org.phrenic.ui.access.panel;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.Session;

/** Where the needle goes in, and in words what is to be said of that way over the breath and at this moment. */
final class EntryPanel extends JPanel implements Session.Listener, RehearsalListener {
    private final transient RehearsalController door;
    private final JToggleButton setEntry = new JToggleButton("Set entry");
    private final JButton best = new JButton("Best path");
    private final JButton bestAtExpiration = new JButton("Best at expiration");
    private final AdvicePanel breathAdvice = new AdvicePanel();
    private final AdvicePanel currentAdvice = new AdvicePanel();
    private final AccessMapLegend legend = new AccessMapLegend();

    EntryPanel(Session session, RehearsalController door) {
        super(PanelRows.columnLayout());
        this.door = door;
        PanelRows.describe(setEntry, "Set entry", "Then click on the skin where the needle goes in (E)");
        PanelRows.describe(best, "Best path", "The entry that is free longest, with room, on the shortest way (B)");
        PanelRows.describe(
                bestAtExpiration, "Best at expiration", "The best entry for a breath held at the end of expiration");
        setEntry.addActionListener(e -> door.pickMode().toggle(PickMode.Kind.ENTRY));
        best.addActionListener(e -> door.entrySelection().selectBest(false));
        bestAtExpiration.addActionListener(e -> door.entrySelection().selectBest(true));
        add(PanelRows.row(setEntry, best, bestAtExpiration), "wmin 0");
        add(legend);
        add(breathAdvice, "wmin 0");
        add(currentAdvice, "wmin 0");
        onState();
        session.addListener(this);
        door.addListener(this);
    }

    @Override
    public void onState() {
        boolean ready = door.stage() == RehearsalStage.READY;
        setEntry.setSelected(door.pickMode().mode() == PickMode.Kind.ENTRY);
        for (JComponent control : new JComponent[] {setEntry, best, bestAtExpiration}) {
            control.setEnabled(ready);
        }
        legend();
        showAdvice();
        showCurrent();
    }

    private void legend() {
        Optional<TargetAccess> study = door.study();
        if (study.isPresent()) {
            Map<String, Object> counts = study.get().map().counts();
            legend.setPercentages(percent(counts, "free"), percent(counts, "in_part"));
        } else {
            legend.setPercentages(-1, -1);
        }
    }

    private static long percent(Map<String, Object> counts, String key) {
        int reach = Math.max(1, (Integer) counts.get("in_reach"));
        return Math.round(100.0 * (Integer) counts.get(key) / reach);
    }

    private void showAdvice() {
        Optional<PathAdvice> advice = door.entrySelection().advice();
        breathAdvice.setVisible(advice.isPresent());
        advice.ifPresent(a -> {
            StringBuilder rest = new StringBuilder(a.way());
            a.reasons().forEach(reason -> rest.append("\n").append(capitalised(reason)));
            if (!a.margin().isEmpty()) {
                rest.append("\nMargin ").append(a.margin());
            }
            breathAdvice.setAdvice(a.level(), a.headline(), rest.toString());
        });
    }

    private static String capitalised(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    @Override
    public void onTick(RunStatus status) {
        if (isShowing()) {
            showCurrent();
        }
    }

    private void showCurrent() {
        Optional<NeedleState> state = door.state().filter(NeedleState::hasNeedle);
        currentAdvice.setVisible(state.isPresent());
        state.ifPresent(this::showCurrent);
    }

    private void showCurrent(NeedleState state) {
        if (!state.warnings().isEmpty()) {
            currentAdvice.setAdvice(PathAdvice.Level.BARRED, "Now: " + String.join("; ", state.warnings()), "");
        } else if (!state.reasons().isEmpty()) {
            currentAdvice.setAdvice(PathAdvice.Level.BARRED, "Now barred: " + String.join("; ", state.reasons()), "");
        } else {
            String margin = state.nearest().isEmpty()
                    ? "nothing near"
                    : String.format(Locale.ROOT, "%.1f mm from %s", state.marginMm(), state.nearest());
            PathAdvice.Level level = state.marginMm() < Rehearsal.SUFFICIENT_MARGIN_MM
                    ? PathAdvice.Level.CAREFUL
                    : PathAdvice.Level.FREE;
            currentAdvice.setAdvice(level, "Now free: " + margin, "");
        }
    }
}
