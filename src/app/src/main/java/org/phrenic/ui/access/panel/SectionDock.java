package org.phrenic.ui.access.panel;

import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.scene.BodySection;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;

/** The section along the needle above the section across it at the tip. */
public final class SectionDock extends JPanel implements RehearsalController.Listener {
    private static final double ALONG_HALF_MM = 105;
    private static final double ACROSS_HALF_MM = 36;
    private static final String HIDDEN_HINT = "Hidden: pictures alone";
    private static final String NO_ENTRY_HINT = "Choose an entry (E)\nor take the best one (B)";

    private final transient RehearsalController rehearsal;
    private final SectionView along = new SectionView("Along the needle", ALONG_HALF_MM, false);
    private final SectionView across = new SectionView("At the tip", ACROSS_HALF_MM, true);
    /** The sections of the needle as it is, also while they are hidden; empty before the first ones. */
    private transient Optional<Sections> latest = Optional.empty();

    private record Sections(BodySection along, BodySection across) {}

    public SectionDock(RehearsalController rehearsal) {
        super(new MigLayout("insets 0, gap 0 2, wrap 1", "[grow, fill, 0::]", "[grow, fill, 0::][grow, fill, 0::]"));
        this.rehearsal = rehearsal;
        setName("sections");
        for (SectionView view : List.of(along, across)) {
            add(view, "hmin 80");
            view.addMouseWheelListener(e -> rehearsal.needle().wheelTurned(e));
        }
        rehearsal.addListener(this);
        onState();
    }

    SectionView along() {
        return along;
    }

    SectionView across() {
        return across;
    }

    @Override
    public void onState() {
        Optional<NeedleState> needle = rehearsal.state().filter(NeedleState::hasNeedle);
        if (needle.isEmpty()) {
            latest = Optional.empty();
        }
        if (isHidden()) {
            showHint(HIDDEN_HINT);
        } else if (needle.isEmpty() || latest.isEmpty()) {
            showHint(needle.isEmpty() && mayChooseEntry() ? NO_ENTRY_HINT : "");
        } else {
            show(needle.get(), latest.get());
        }
    }

    private boolean isHidden() {
        return rehearsal.pictures().aids() == Aids.PICTURES;
    }

    private boolean mayChooseEntry() {
        return rehearsal.stage() == RehearsalStage.READY
                && rehearsal.entrySelection().entry().isEmpty();
    }

    private void showHint(String why) {
        List.of(along, across).forEach(view -> view.show(null, PathAdvice.Level.FREE, false, why));
    }

    private void show(NeedleState needle, Sections sections) {
        PathAdvice.Level level = rehearsal.entrySelection().levelNow(needle);
        along.show(sections.along, level, needle.placed(), "");
        across.show(sections.across, level, needle.placed(), "");
    }

    @Override
    public void onSections(BodySection alongNeedle, BodySection acrossNeedle) {
        Sections sections = new Sections(alongNeedle, acrossNeedle);
        rehearsal.state().filter(NeedleState::hasNeedle).ifPresent(needle -> {
            latest = Optional.of(sections);
            if (!isHidden()) {
                show(needle, sections);
            }
        });
    }
}
