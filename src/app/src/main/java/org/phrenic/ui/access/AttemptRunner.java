package org.phrenic.ui.access;

import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.LiveAttempt;
import org.phrenic.access.plan.LiveRehearsal;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.scene.BodySection;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;

/**
 * An attempt in the run, by hand or played, from its start to its report. On the event dispatch thread, but for
 * {@link #state}.
 */
final class AttemptRunner implements AutoCloseable {
    /** Told on the event dispatch thread. */
    interface Listener {
        /** What was asked cannot be done, in one sentence. */
        void onRefused(String sentence);

        /** Other sections: along the needle, and across it. */
        void onSections(BodySection along, BodySection across);

        /** All that was to be done is done. */
        void onEnded(boolean played);

        /** The report is there. */
        void onReport(Rehearsal rehearsal);
    }

    private final Session session;
    private final ObservedRun run;
    private final BackgroundWorker work;
    private final Listener listener;
    private final ExecutorService sectionThread = BackgroundWorker.daemonThread("phrenic-section");
    private volatile LiveRehearsal rehearsal;

    /** @param work beside which the report is put together */
    AttemptRunner(Session session, ObservedRun run, BackgroundWorker work, Listener told) {
        this.session = session;
        this.run = run;
        this.work = work;
        this.listener = told;
    }

    /**
     * Begins from the start of the run.
     *
     * @param plan needle, what it should avoid, what counts as done
     * @param played whether its steps are played; else it is by hand
     * @param entry where the needle is meant to go in, if that is chosen already
     */
    void start(RehearsalBody body, TargetAccess about, RehearsalPlan plan, boolean played, Optional<double[]> entry) {
        BooleanSupplier current = work.notDiscardedSince();
        LiveRehearsal watching = new LiveRehearsal(
                session.live(),
                body.simulatedScene(),
                body.frame(),
                plan,
                about.target(),
                played ? Optional.of(about.map()) : Optional.empty(),
                new LiveRehearsal.Listener() {
                    @Override
                    public void refused(String sentence) {
                        SwingUtilities.invokeLater(() -> listener.onRefused(sentence));
                    }

                    @Override
                    public void finished(LiveAttempt attempt) {
                        SwingUtilities.invokeLater(() -> {
                            if (current.getAsBoolean()) {
                                publishReport(body, about, played ? plan : attempt.toPlan(plan), attempt);
                                listener.onEnded(played);
                            }
                        });
                    }
                });
        SectionUpdater feed = new SectionUpdater(
                sectionThread, body.scene().surfaces(), body.scene().newFrame().get(), (along, across) -> {
                    if (current.getAsBoolean()) {
                        listener.onSections(along, across);
                    }
                });
        entry.ifPresent(watching::enterAt);
        rehearsal = watching;
        run.restartAtUserSpeed(StepListener.Trigger.every(Rehearsal.FRAME_INTERVAL_S), (frame, label) -> {
            watching.onStep(frame, label);
            feed.offer(frame, watching.state());
        });
    }

    /** An attempt that has ended counts, whatever was begun meanwhile. */
    private void publishReport(RehearsalBody body, TargetAccess about, RehearsalPlan done, LiveAttempt attempt) {
        work.runAlways(
                () -> new Rehearsal(
                        done,
                        body.scene().surfaces(),
                        about,
                        Rehearsal.plannedPath(done, about, body.planningScene()),
                        attempt.record(),
                        attempt.snapshots(),
                        attempt.stateHash()),
                listener::onReport,
                listener::onRefused);
    }

    /** Nobody is at it any more. */
    void detach() {
        rehearsal = null;
    }

    /** The needle in the run; empty if there is none. */
    Optional<LiveRehearsal> rehearsal() {
        return Optional.ofNullable(rehearsal);
    }

    /** How it stands; empty before the first look. On any thread. */
    Optional<NeedleState> state() {
        LiveRehearsal now = rehearsal;
        return now == null ? Optional.empty() : Optional.ofNullable(now.state());
    }

    @Override
    public void close() {
        sectionThread.shutdownNow();
    }
}
