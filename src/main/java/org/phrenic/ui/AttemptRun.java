package org.phrenic.ui;

import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;
import org.phrenic.rehearsal.LiveAttempt;
import org.phrenic.rehearsal.LiveRehearsal;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.scene.Section;
import org.phrenic.simulation.live.Watch;

/** An attempt in the run, by hand or played, from its start to its report. On the event dispatch thread, but for {@link #state}. */
final class AttemptRun implements AutoCloseable {
    /** Told on the event dispatch thread. */
    interface Told {
        /** What was asked cannot be done, in one sentence. */
        void refused(String sentence);

        /** Other sections: along the needle, and across it. */
        void cut(Section along, Section across);

        /** All that was to be done is done. */
        void over(boolean played);

        /** The report is there. */
        void reported(Rehearsal rehearsal);
    }

    private final Session session;
    private final WatchedRun run;
    private final Background work;
    private final Told told;
    private final ExecutorService cutter = Background.thread("phrenic-section");
    private volatile LiveRehearsal rehearsal;

    /** @param work beside which the report is put together */
    AttemptRun(Session session, WatchedRun run, Background work, Told told) {
        this.session = session;
        this.run = run;
        this.work = work;
        this.told = told;
    }

    /**
     * Begins from the start of the run.
     *
     * @param plan needle, what it should avoid, what counts as done
     * @param played whether its steps are played; else it is by hand
     * @param entry where the needle is meant to go in, if that is chosen already
     */
    void begin(RehearsedBody body, TargetStudy about, RehearsalPlan plan, boolean played, Optional<double[]> entry) {
        BooleanSupplier current = work.current();
        LiveRehearsal watching = new LiveRehearsal(
                session.live(),
                body.lived(),
                body.frame(),
                plan,
                about.target(),
                played ? Optional.of(about.map()) : Optional.empty(),
                new LiveRehearsal.Listener() {
                    @Override
                    public void refused(String sentence) {
                        SwingUtilities.invokeLater(() -> told.refused(sentence));
                    }

                    @Override
                    public void finished(LiveAttempt attempt) {
                        SwingUtilities.invokeLater(() -> {
                            if (current.getAsBoolean()) {
                                report(body, about, played ? plan : attempt.planned(plan), attempt);
                                told.over(played);
                            }
                        });
                    }
                });
        SectionFeed feed = new SectionFeed(
                cutter, body.scene().surfaces(), body.scene().newFrame().get(), (along, across) -> {
                    if (current.getAsBoolean()) {
                        told.cut(along, across);
                    }
                });
        entry.ifPresent(watching::enterAt);
        rehearsal = watching;
        run.startAtSpeed(Watch.When.every(Rehearsal.LOOK_EVERY_S), (frame, label) -> {
            watching.see(frame, label);
            feed.offer(frame, watching.state());
        });
    }

    /** An attempt that has ended counts, whatever was begun meanwhile. */
    private void report(RehearsedBody body, TargetStudy about, RehearsalPlan done, LiveAttempt attempt) {
        work.keep(
                () -> new Rehearsal(
                        done,
                        body.scene().surfaces(),
                        about,
                        Rehearsal.plannedPath(done, about, body.mapped()),
                        attempt.record(),
                        attempt.views(),
                        attempt.stateHash()),
                told::reported,
                told::refused);
    }

    /** Nobody is at it any more. */
    void leave() {
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
        cutter.shutdownNow();
    }
}
