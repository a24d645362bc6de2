package org.phrenic.ui.access.panel;

import java.awt.BorderLayout;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import net.miginfocom.swing.MigLayout;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.ScrollablePanel;
import org.phrenic.ui.widget.Theme;

/**
 * The clinician's controls in the order of use: exercise, breath, target, entry, needle. Those of the needle stay at
 * the bottom, whatever is said above them; the others scroll.
 */
public final class RehearsalDock extends JPanel {
    /** @param presetSelector changes the breathing preset */
    public RehearsalDock(Session session, RehearsalController rehearsal, Consumer<String> presetSelector) {
        super(new BorderLayout());
        setName("rehearse");
        JPanel body = new ScrollablePanel(
                new MigLayout("insets 8 10 8 10, gap 6 8, fillx, hidemode 3, wrap 1, novisualpadding", "[grow, fill]"));
        body.add(new ExercisePanel(session, rehearsal), "wmin 0");
        body.add(new BreathPanel(session, rehearsal, presetSelector), "wmin 0");
        body.add(new TargetPanel(session, rehearsal), "wmin 0");
        body.add(new EntryPanel(session, rehearsal), "wmin 0");
        JScrollPane scroll = ScrollablePanel.scrollPane(body);
        // A bar that came and went would break the texts into other lines, and move the list of exercises.
        scroll.setVerticalScrollBarPolicy(ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS);
        add(scroll, BorderLayout.CENTER);
        WrappingLabel notice = WrappingLabel.small("Notice");
        notice.setTextIfChanged(Disclaimer.TEXT);
        JPanel bottom = Controls.panel(
                "insets 8 10 6 10, gap 6 8, fillx, wrap 1, novisualpadding",
                "[grow, fill, 0::]",
                new NeedlePanel(session, rehearsal),
                notice);
        bottom.setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Theme.BORDER));
        add(bottom, BorderLayout.SOUTH);
    }
}
