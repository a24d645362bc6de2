package org.phrenic.ui.chart;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;

/** Shows recorded frames, while the simulation is paused; Live returns to the present and resumes it. */
public final class TimelineDock extends JPanel implements Session.Listener {
    private final transient Session session;
    private final transient SampleRingBuffer ring = new SampleRingBuffer(Observation.COLUMNS.size(), RunHistory.ROWS);
    private final TimelineBar bar = new TimelineBar(this::seek, this::stepFrames);
    private final JButton previousFrame = Controls.button("\u25c2", "Previous recorded frame", () -> stepFrames(-1));
    private final JButton nextFrame = Controls.button("\u25b8", "Next recorded frame", () -> stepFrames(1));
    private final JButton liveButton;
    private final JLabel time = new JLabel(" ");
    private transient RunStatus shown = RunStatus.NOTHING;

    public TimelineDock(Session session) {
        super(new MigLayout("insets 4 8 4 8, fillx", "[][][][140!][grow,fill]"));
        this.session = session;
        liveButton = Controls.button("Live", "Back to the present", session::returnToLive);
        for (JButton button : new JButton[] {previousFrame, nextFrame, liveButton}) {
            button.getAccessibleContext().setAccessibleName(button.getToolTipText());
            add(button);
        }
        add(time);
        add(bar);
        refresh();
        session.addListener(this);
    }

    private void seek(double wanted) {
        RunHistory history = session.live().history();
        if (history == null || history.frames() == 0) {
            return;
        }
        IntStream.range(0, history.frames())
                .boxed()
                .min(Comparator.comparingDouble(i -> Math.abs(history.frameTime(i) - wanted)))
                .ifPresent(session::showHistoryFrame);
    }

    /** Goes a number of frames on; beyond the last it returns to the present. */
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
        boolean stopped = !status.playing() && shown.playing();
        boolean stepped = !status.playing() && status.step() != shown.step();
        shown = status;
        if (stopped || stepped || (isShowing() && (any || session.historyFrame().isPresent()))) {
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
        String state = scrubbing ? "recorded" : session.live().isPlaying() ? "live" : "paused";
        time.setText(Numbers.format("%.2f s, %s", shown, state));
    }
}
