package org.phrenic.ui.dock;

import java.awt.BorderLayout;
import javax.swing.JPanel;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.ScrollablePanel;

/** A dock whose rows show values of the scenario; {@link #onChange} shows them again. */
abstract class SessionDock extends JPanel implements Session.Listener {
    final transient Session session;
    final JPanel body = new ScrollablePanel();

    SessionDock(Session session) {
        super(new BorderLayout());
        this.session = session;
        add(ScrollablePanel.scrollPane(body), BorderLayout.CENTER);
    }

    /** Shows the present values, and follows them from here on; called at the end of a constructor. */
    final void follow() {
        onChange();
        session.addListener(this);
    }

    @Override
    public abstract void onChange();

    @Override
    public void onScene(LiveScene scene) {
        onChange();
    }
}
