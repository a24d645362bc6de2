package org.phrenic.ui.access.panel;

import java.awt.BorderLayout;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.ScrollablePanel;
import org.phrenic.ui.widget.WindowNotice;

/** The clinician's controls, from top to bottom in the order of use: exercise, breath, target, way in, needle. */
public final class RehearsalDock extends JPanel {
    /** @param breathing told by which preset to breathe */
    public RehearsalDock(Session session, RehearsalController door, Consumer<String> breathing) {
        super(new BorderLayout());
        setName("rehearse");
        JPanel body = new ScrollablePanel(
                new MigLayout("insets 8 10 8 10, gap 6 8, fillx, hidemode 3, wrap 1, novisualpadding", "[grow, fill]"));
        body.add(new ExercisePanel(door), "wmin 0");
        body.add(new BreathPanel(session, door, breathing), "wmin 0");
        body.add(new TargetPanel(door), "wmin 0");
        body.add(new EntryPanel(session, door), "wmin 0");
        body.add(new NeedlePanel(session, door), "wmin 0");
        add(ScrollablePanel.scrollPane(body), BorderLayout.CENTER);
        JLabel notice = new JLabel(WindowNotice.TEXT);
        notice.putClientProperty("FlatLaf.styleClass", "small");
        JPanel foot = new JPanel(new MigLayout("insets 4 10 6 10", "[grow, fill, 0::]"));
        foot.add(notice, "wmin 0");
        add(foot, BorderLayout.SOUTH);
    }
}
