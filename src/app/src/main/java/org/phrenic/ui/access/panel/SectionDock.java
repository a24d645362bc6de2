package org.phrenic.ui.access.panel;

import java.util.List;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.scene.BodySection;
import org.phrenic.ui.access.RehearsalController;

/** The section along the needle above the section across it at the tip. */
public final class SectionDock extends JPanel implements RehearsalController.Listener {
    private static final double ALONG_HALF_MM = 105;
    private static final double ACROSS_HALF_MM = 36;
    private static final String HIDDEN_HINT = "Hidden: pictures alone";
    private static final String NO_ENTRY_HINT = "Choose an entry (E)\nor take the best path (B)";

    private final transient RehearsalController rehearsal;
    private final SectionView along = new SectionView("Along the needle", ALONG_HALF_MM, false);
    private final SectionView across = new SectionView("At the tip", ACROSS_HALF_MM, true);

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
        if (isHidden()) {
            List.of(along, across).forEach(view -> view.show(null, PathAdvice.Level.FREE, false, HIDDEN_HINT));
        } else if (rehearsal.state().filter(NeedleState::hasNeedle).isEmpty()) {
            List.of(along, across).forEach(view -> view.show(null, PathAdvice.Level.FREE, false, NO_ENTRY_HINT));
        }
    }

    private boolean isHidden() {
        return rehearsal.pictures().aids() == Aids.PICTURES;
    }

    @Override
    public void onSections(BodySection alongNeedle, BodySection acrossNeedle) {
        if (isHidden()) {
            return;
        }
        rehearsal.state().filter(NeedleState::hasNeedle).ifPresent(state -> {
            PathAdvice.Level level = rehearsal.entrySelection().levelNow(state);
            along.show(alongNeedle, level, state.placed(), "");
            across.show(acrossNeedle, level, state.placed(), "");
        });
    }
}
