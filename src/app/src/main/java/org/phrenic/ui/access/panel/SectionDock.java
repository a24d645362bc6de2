package org.phrenic.ui.access.panel;

import java.util.Optional;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.scene.BodySection;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;

/** The section along the needle and what lies at its tip, one above the other. */
public final class SectionDock extends JPanel implements RehearsalListener {
    private static final double ALONG_HALF_MM = 105;
    private static final double ACROSS_HALF_MM = 36;
    private static final String NO_ENTRY_HINT = "Choose an entry (E)\nor take the best path (B)";

    private final transient RehearsalController door;
    private final SectionView along = new SectionView("Along the needle", ALONG_HALF_MM, false);
    private final SectionView across = new SectionView("At the tip", ACROSS_HALF_MM, true);

    public SectionDock(RehearsalController door) {
        super(new MigLayout("insets 0, gap 0 2, wrap 1", "[grow, fill, 0::]", "[grow, fill, 0::][grow, fill, 0::]"));
        this.door = door;
        setName("sections");
        add(along, "hmin 80");
        add(across, "hmin 80");
        along.addMouseWheelListener(e -> door.needle().wheelTurned(e));
        across.addMouseWheelListener(e -> door.needle().wheelTurned(e));
        door.addListener(this);
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
        if (door.state().filter(NeedleState::hasNeedle).isEmpty()) {
            along.show(null, PathAdvice.Level.FREE, false, NO_ENTRY_HINT);
            across.show(null, PathAdvice.Level.FREE, false, NO_ENTRY_HINT);
        }
    }

    @Override
    public void onSections(BodySection one, BodySection other) {
        Optional<NeedleState> state = door.state().filter(NeedleState::hasNeedle);
        state.ifPresent(now -> {
            along.show(one, door.entrySelection().levelNow(now), now.placed(), "");
            across.show(other, door.entrySelection().levelNow(now), now.placed(), "");
        });
    }
}
