package org.phrenic.ui;

import java.util.Optional;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.PathAdvice;
import org.phrenic.scene.Section;
import org.phrenic.ui.clinic.SectionView;

/** The section along the needle and what lies at its tip, one above the other. */
final class SectionDock extends JPanel implements DoorEvents {
    private static final double ALONG_HALF_MM = 105;
    private static final double ACROSS_HALF_MM = 36;
    private static final String NONE = "Choose an entry (E)\nor take the best path (B)";

    private final transient RehearsalDoor door;
    private final SectionView along = new SectionView("Along the needle", ALONG_HALF_MM, false);
    private final SectionView across = new SectionView("At the tip", ACROSS_HALF_MM, true);

    SectionDock(RehearsalDoor door) {
        super(new MigLayout("insets 0, gap 0 2, wrap 1", "[grow, fill, 0::]", "[grow, fill, 0::][grow, fill, 0::]"));
        this.door = door;
        setName("sections");
        add(along, "hmin 80");
        add(across, "hmin 80");
        along.addMouseWheelListener(e -> door.hand().turned(e));
        across.addMouseWheelListener(e -> door.hand().turned(e));
        door.listen(this);
        onDoor();
    }

    SectionView along() {
        return along;
    }

    SectionView across() {
        return across;
    }

    @Override
    public void onDoor() {
        if (door.state().filter(NeedleState::hasNeedle).isEmpty()) {
            along.show(null, PathAdvice.Level.FREE, false, NONE);
            across.show(null, PathAdvice.Level.FREE, false, NONE);
        }
    }

    @Override
    public void onSections(Section one, Section other) {
        Optional<NeedleState> state = door.state().filter(NeedleState::hasNeedle);
        state.ifPresent(now -> {
            along.show(one, door.way().level(now), now.placed(), "");
            across.show(other, door.way().level(now), now.placed(), "");
        });
    }
}
