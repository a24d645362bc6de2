package org.phrenic.ui.chart;

import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.session.Session;

/**
 * Scrubs through the recorded breath. While a recorded frame is looked at the simulation stands still; Live goes back
 * to the present, and on.
 */
public final class TimelineDock extends JPanel implements Session.Listener {
    /** Rows that cover the frames at hand: ten seconds and more at 50 a second. */
    private static final int MAX_SAMPLES = 1500;

    private final transient Session session;
    private final transient SampleRingBuffer ring = new SampleRingBuffer(Observation.COLUMNS.size(), MAX_SAMPLES);
    private final TimelineBar bar = new TimelineBar(this::seek, this::stepFrames);
    private final JButton previousFrame = new JButton("\u25c2");
    private final JButton nextFrame = new JButton("\u25b8");
    private final JButton liveButton = new JButton("Live");
    private final JLabel time = new JLabel(" ");

    public TimelineDock(Session session) {
        super(new MigLayout("insets 4 8 4 8, fillx", "[][][][140!][grow,fill]"));
        this.session = session;
        button(previousFrame, "One recorded frame back", () -> stepFrames(-1));
        button(nextFrame, "One recorded frame on", () -> stepFrames(1));
        button(liveButton, "Back to the present, and on", session::returnToLive);
        add(previousFrame);
        add(nextFrame);
        add(liveButton);
        add(time);
        add(bar);
        refresh();
        session.addListener(this);
    }

    private static void button(JButton button, String tip, Runnable what) {
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip);
        button.addActionListener(e -> what.run());
    }

    private void seek(double wanted) {
        RunHistory history = session.live().history();
        if (history == null || history.frames() == 0) {
            return;
        }
        int nearest = 0;
        for (int i = 1; i < history.frames(); i++) {
            if (Math.abs(history.frameTime(i) - wanted) < Math.abs(history.frameTime(nearest) - wanted)) {
                nearest = i;
            }
        }
        session.showHistoryFrame(nearest);
    }

    /** Goes so many frames on; beyond the last it follows the present. */
    public void stepFrames(int frames) {
        RunHistory history = session.live().history();
        if (history == null || history.frames() == 0) {
            return;
        }
        int last = history.frames() - 1;
        long next = (long) session.historyFrame().orElse(last) + frames;
        if (next > last) {
            session.returnToLive();
        } else {
            session.showHistoryFrame((int) Math.max(0, next));
        }
    }

    @Override
    public void onScene(LiveScene scene) {
        ring.clear();
        refresh();
    }

    @Override
    public void onScrub() {
        refresh();
    }

    @Override
    public void onTick(RunStatus status) {
        RunHistory history = session.live().history();
        boolean any = ring.update(history);
        if (isShowing() && (any || session.historyFrame().isPresent())) {
            refresh();
        }
    }

    private void refresh() {
        boolean scrubbing = session.historyFrame().isPresent();
        RunHistory history = session.live().history();
        int frames = history == null ? 0 : history.frames();
        liveButton.setEnabled(scrubbing);
        previousFrame.setEnabled(frames > 0 && session.historyFrame().orElse(frames) > 0);
        nextFrame.setEnabled(scrubbing);
        if (frames == 0) {
            time.setText("Nothing recorded yet");
            bar.setTimeline(0, 1, Double.NaN, List.of());
            return;
        }
        double from = history.frameTime(0);
        double now = session.live().status().timeS();
        double to = Math.max(history.frameTime(frames - 1), scrubbing ? 0 : now);
        double shown = scrubbing ? history.frameTime(session.historyFrame().getAsInt()) : now;
        bar.setTimeline(from, to, shown, PhaseBands.of(ring, from, to));
        time.setText(
                scrubbing
                        ? String.format(Locale.ROOT, "%.2f s, recorded", shown)
                        : String.format(Locale.ROOT, "%.2f s, %s", shown, liveStateText()));
    }

    private String liveStateText() {
        return session.live().isPlaying() ? "live" : "paused";
    }
}
