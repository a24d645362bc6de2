package org.phrenic.ui;

import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.live.History;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/** Scrubs through the recorded breath. While a recorded frame is looked at the simulation stands still; Live goes back to the present, and on. */
public final class TimelineDock extends JPanel implements Session.Events {
    /** Rows that cover the frames at hand: ten seconds and more at 50 a second. */
    private static final int ROWS = 1500;

    private final transient Session session;
    private final transient HistoryFeed feed = new HistoryFeed(new SampleRing(Observation.COLUMNS.size(), ROWS));
    private final TimelineBar bar = new TimelineBar(this::seek, this::go);
    private final JButton back = new JButton("\u25c2");
    private final JButton forth = new JButton("\u25b8");
    private final JButton live = new JButton("Live");
    private final JLabel time = new JLabel(" ");

    public TimelineDock(Session session) {
        super(new MigLayout("insets 4 8 4 8, fillx", "[][][][140!][grow,fill]"));
        this.session = session;
        button(back, "One recorded frame back", () -> go(-1));
        button(forth, "One recorded frame on", () -> go(1));
        button(live, "Back to the present, and on", session::follow);
        add(back);
        add(forth);
        add(live);
        add(time);
        add(bar);
        refresh();
        session.listen(this);
    }

    private static void button(JButton button, String tip, Runnable what) {
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip);
        button.addActionListener(e -> what.run());
    }

    private void seek(double wanted) {
        History history = session.live().history();
        if (history == null || history.frames() == 0) {
            return;
        }
        int nearest = 0;
        for (int i = 1; i < history.frames(); i++) {
            if (Math.abs(history.frameTime(i) - wanted) < Math.abs(history.frameTime(nearest) - wanted)) {
                nearest = i;
            }
        }
        session.scrub(nearest);
    }

    /** Goes so many frames on; beyond the last it follows the present. */
    void go(int frames) {
        History history = session.live().history();
        if (history == null || history.frames() == 0) {
            return;
        }
        int last = history.frames() - 1;
        long next = (long) session.scrubbed().orElse(last) + frames;
        if (next > last) {
            session.follow();
        } else {
            session.scrub((int) Math.max(0, next));
        }
    }

    @Override
    public void onScene(LiveScene scene) {
        feed.restart();
        refresh();
    }

    @Override
    public void onScrub() {
        refresh();
    }

    @Override
    public void onTick(Status status) {
        History history = session.live().history();
        boolean any = feed.pull(history);
        if (isShowing() && (any || session.scrubbed().isPresent())) {
            refresh();
        }
    }

    private void refresh() {
        boolean scrubbing = session.scrubbed().isPresent();
        History history = session.live().history();
        int frames = history == null ? 0 : history.frames();
        live.setEnabled(scrubbing);
        back.setEnabled(frames > 0 && session.scrubbed().orElse(frames) > 0);
        forth.setEnabled(scrubbing);
        if (frames == 0) {
            time.setText("Nothing recorded yet");
            bar.show(0, 1, Double.NaN, List.of());
            return;
        }
        double from = history.frameTime(0);
        double now = session.live().status().timeS();
        double to = Math.max(history.frameTime(frames - 1), scrubbing ? 0 : now);
        double shown = scrubbing ? history.frameTime(session.scrubbed().getAsInt()) : now;
        bar.show(from, to, shown, BreathBands.of(feed.ring(), from, to));
        time.setText(
                scrubbing
                        ? String.format(Locale.ROOT, "%.2f s, recorded", shown)
                        : String.format(Locale.ROOT, "%.2f s, %s", shown, present()));
    }

    private String present() {
        return session.live().isPlaying() ? "live" : "paused";
    }
}
