package org.phrenic.ui.access;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.LiveAttempt;
import org.phrenic.access.plan.LiveRehearsal;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;

/**
 * An attempt in the run, by hand or played, from its start to its report. Used on the event dispatch thread, except
 * {@link #state}.
 */
final class AttemptRunner implements AutoCloseable {
    private final Session session;
    private final BackgroundWorker work;
    private final RehearsalController controller;
    private final ExecutorService sectionThread = BackgroundWorker.daemonThread("phrenic-section");
    private final ExecutorService ultrasoundThread = BackgroundWorker.daemonThread("phrenic-ultrasound");
    private volatile LiveRehearsal rehearsal;

    AttemptRunner(Session session, BackgroundWorker work, RehearsalController controller) {
        this.session = session;
        this.work = work;
        this.controller = controller;
    }

    /**
     * Starts from the start of the run.
     *
     * @param plan needle, no-go structures and goals
     * @param played whether the steps of the plan are played
     * @param entry entry of the needle, if one is chosen
     */
    void start(
            RehearsalBody body,
            TargetAccess about,
            RehearsalPlan plan,
            boolean played,
            Optional<EntrySelection.Entry> entry) {
        BooleanSupplier current = work.notDiscardedSince();
        LiveRehearsal.Listener listener = new LiveRehearsal.Listener() {
            @Override
            public void refused(String sentence) {
                SwingUtilities.invokeLater(() -> session.refuse(sentence));
            }

            @Override
            public void finished(LiveAttempt attempt) {
                SwingUtilities.invokeLater(() -> {
                    if (current.getAsBoolean()) {
                        publishReport(body, about, played ? plan : attempt.toPlan(plan), attempt);
                        controller.onAttemptEnded(played);
                    }
                });
            }
        };
        Optional<AccessMap> map = played ? Optional.of(about.map()) : Optional.empty();
        LiveRehearsal watching = new LiveRehearsal(
                session.live(), body.simulatedScene(), body.frame(), plan, about.target(), map, listener);
        SectionUpdater feed = new SectionUpdater(
                sectionThread, body.scene().surfaces(), body.scene().newFrame().get(), (along, across) -> {
                    if (current.getAsBoolean()) {
                        controller.fire(l -> l.onSections(along, across));
                    }
                });
        UltrasoundUpdater images = new UltrasoundUpdater(
                ultrasoundThread,
                body.scene().surfaces(),
                about.target(),
                body.scene().newFrame().get(),
                controller.pictures()::latencyS,
                shot -> {
                    if (current.getAsBoolean()) {
                        controller.fire(l -> l.onUltrasound(shot));
                    }
                });
        entry.ifPresent(e -> watching.enterAt(e.restMm(), e.angles()));
        if (!played && controller.probe().hold().isPresent()) {
            watching.holdProbe(controller.probe().hold());
        }
        rehearsal = watching;
        session.restart(
                StepListener.Trigger.every(Rehearsal.FRAME_INTERVAL_S), new WithPictures(watching, feed, images));
        session.restoreSpeed();
    }

    /** Hands on the steps of the run to the needle, and its frames to sections and pictures too. */
    private record WithPictures(LiveRehearsal needle, SectionUpdater sections, UltrasoundUpdater images)
            implements StepListener {
        @Override
        public void onStep(Frame frame, RespiratoryPhase label) {
            needle.onStep(frame, label);
            sections.offer(frame, needle.state());
            images.offer(frame, needle.imageMoment(), needle.state());
        }

        @Override
        public boolean needsFrame() {
            return needle.needsFrame();
        }

        @Override
        public void onStepWithoutFrame(double timeS, RespiratoryPhase label, int breath) {
            needle.onStepWithoutFrame(timeS, label, breath);
        }
    }

    /** Composes the report in the background; it is never discarded. */
    private void publishReport(RehearsalBody body, TargetAccess about, RehearsalPlan done, LiveAttempt attempt) {
        Callable<Rehearsal> report = () -> {
            Optional<PathOverBreath> path = Rehearsal.plannedPath(done, about, body.planningScene());
            List<Surface> surfaces = body.scene().surfaces();
            return new Rehearsal(
                    done,
                    surfaces,
                    about,
                    path,
                    attempt.record(),
                    attempt.probe(),
                    attempt.snapshots(),
                    attempt.stateHash());
        };
        work.runAlways(report, controller::onReport, session::refuse);
    }

    void detach() {
        rehearsal = null;
    }

    /** The needle in the run; empty if there is none. */
    Optional<LiveRehearsal> rehearsal() {
        return Optional.ofNullable(rehearsal);
    }

    /** State of the needle; empty before the first frame. On any thread. */
    Optional<NeedleState> state() {
        LiveRehearsal now = rehearsal;
        return now == null ? Optional.empty() : Optional.ofNullable(now.state());
    }

    @Override
    public void close() {
        sectionThread.shutdownNow();
        ultrasoundThread.shutdownNow();
    }
}
