package org.phrenic.ui.access.panel;

import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JToggleButton;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.access.EntrySelection;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;

/**
 * The entry of the needle, and advice on the path: at present, then over the breath. The advice over the breath has no
 * colour while the present is worse.
 */
final class EntryPanel extends AccessPanel {
    private final JToggleButton setEntry =
            toggle("Set entry", "Set entry", "Then click on the skin where the needle goes in (E)", () -> rehearsal
                    .pickMode()
                    .toggle(PickMode.Kind.ENTRY));
    private final JButton best = button(
            "Best entry",
            "Free longest, with a sufficient margin, on the shortest path; the needle stands upright there: aim it"
                    + " by the arrow keys or Aim for me (B)",
            () -> rehearsal.entrySelection().selectBest(false));
    private final JButton bestAtExpiration = button(
            "Best at expiration",
            "The best entry for a breath held at end-expiration, the needle upright",
            () -> rehearsal.entrySelection().selectBest(true));
    private final AdvicePanel breathAdvice = new AdvicePanel("Path over the breath");
    private final AdvicePanel currentAdvice = new AdvicePanel("Path at present");
    private final AccessMapLegend legend = new AccessMapLegend();

    EntryPanel(Session session, RehearsalController rehearsal) {
        super(rehearsal);
        addAll(row(setEntry, best, bestAtExpiration), legend, currentAdvice, breathAdvice);
        follow(session);
    }

    @Override
    public void onState() {
        setEntry.setSelected(rehearsal.pickMode().mode() == PickMode.Kind.ENTRY);
        setEnabled(isReady(), setEntry, best, bestAtExpiration);
        showLegend();
        showAdvice();
        showCurrent();
    }

    private boolean isAdvised() {
        return rehearsal.pictures().aids() != Aids.PICTURES;
    }

    private void showLegend() {
        legend.setVisible(rehearsal.pictures().aids() == Aids.SEE_THROUGH);
        Optional<AccessMap.Counts> counts =
                rehearsal.study().map(study -> study.map().counts());
        counts.ifPresentOrElse(
                c -> legend.setPercentages(percent(c.free(), c), percent(c.part(), c)),
                () -> legend.setPercentages(-1, -1));
    }

    private static long percent(int points, AccessMap.Counts counts) {
        return Math.round(100.0 * points / Math.max(1, counts.inReach()));
    }

    private void showAdvice() {
        Optional<PathAdvice> advice = rehearsal.entrySelection().advice();
        Optional<String> none = rehearsal.entrySelection().unadvised();
        breathAdvice.setVisible((advice.isPresent() || none.isPresent()) && isAdvised());
        none.ifPresent(breathAdvice::setUnknown);
        advice.ifPresent(a -> {
            StringBuilder rest = new StringBuilder(a.way());
            a.reasons().forEach(reason -> rest.append("\n").append(Controls.capitalise(reason)));
            if (!a.margin().isEmpty()) {
                rest.append("\nMargin ").append(a.margin());
            }
            breathAdvice.setAdvice(a.level(), a.headline(), rest.toString());
        });
    }

    @Override
    public void onTick(RunStatus status) {
        if (isShowing()) {
            showCurrent();
        }
    }

    private void showCurrent() {
        Optional<NeedleState> state = rehearsal.state().filter(NeedleState::hasNeedle);
        currentAdvice.setVisible(state.isPresent() && isAdvised());
        state.ifPresent(this::showCurrent);
        breathAdvice.giveWayTo(currentAdvice);
    }

    private void showCurrent(NeedleState state) {
        PathAdvice.Level level = EntrySelection.presentLevel(state);
        // The part of the needle in the body warns of what bars the whole path too.
        String warnings = state.warnings().stream()
                .filter(warning -> !state.reasons().contains(warning))
                .collect(Collectors.joining("; "));
        if (!state.reasons().isEmpty()) {
            currentAdvice.setAdvice(
                    level, "Now barred: " + String.join("; ", state.reasons()), Controls.capitalise(warnings));
        } else if (!warnings.isEmpty()) {
            currentAdvice.setAdvice(level, "Now: " + warnings, "");
        } else {
            String margin = state.nearest().isEmpty()
                    ? "nothing near"
                    : Numbers.format("%.1f mm from %s", state.marginMm(), state.nearest());
            currentAdvice.setAdvice(level, "Now free: " + margin, "");
        }
    }
}
