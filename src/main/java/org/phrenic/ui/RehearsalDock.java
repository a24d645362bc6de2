package org.phrenic.ui;

import java.awt.BorderLayout;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/** The clinician's controls, from top to bottom in the order of use: exercise, breath, target, way in, needle. */
final class RehearsalDock extends JPanel {
    /** @param breathing told by which preset to breathe */
    RehearsalDock(Session session, RehearsalDoor door, Consumer<String> breathing) {
        super(new BorderLayout());
        setName("rehearse");
        JPanel body = new DockBody(
                new MigLayout("insets 8 10 8 10, gap 6 8, fillx, hidemode 3, wrap 1, novisualpadding", "[grow, fill]"));
        body.add(new ExerciseSection(door), "wmin 0");
        body.add(new BreathSection(session, door, breathing), "wmin 0");
        body.add(new TargetSection(door), "wmin 0");
        body.add(new WayInSection(session, door), "wmin 0");
        body.add(new NeedleSection(session, door), "wmin 0");
        add(DockBody.scroll(body), BorderLayout.CENTER);
        JLabel notice = new JLabel(Notice.TEXT);
        notice.putClientProperty("FlatLaf.styleClass", "small");
        JPanel foot = new JPanel(new MigLayout("insets 4 10 6 10", "[grow, fill, 0::]"));
        foot.add(notice, "wmin 0");
        add(foot, BorderLayout.SOUTH);
    }
}
