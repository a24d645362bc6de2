package org.phrenic.ui.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.phrenic.access.live.AttemptListener;
import org.phrenic.access.live.LiveAttempt;
import org.phrenic.access.live.LiveRehearsal;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.FileWrites;
import org.phrenic.ui.session.Session;

/**
 * An attempt in the run, by hand or played, from its start to its report. Used on the event dispatch thread, except
 * {@link #state}.
 */
final class AttemptRunner implements Session.Listener, AutoCloseable {
    private final Session session;
    private final BackgroundWorker work;
    private final RehearsalController controller;
    private final ExecutorService sectionThread = BackgroundWorker.daemonThread("phrenic-section");
    private final ExecutorService pictureThread = BackgroundWorker.daemonThread("phrenic-pictures");
    private volatile LiveRehearsal rehearsal;
    /** Attempts whose reports are being composed. */
    private final List<FileWrites> unpublished = new ArrayList<>();
    /** That of the present attempt. */
    private ShownHelp help = new ShownHelp();

    private boolean closed;
    /** Whether the attempt is played, so that its needle takes no commands. */
    private boolean isPlayed;

    /** The most help that was shown in an attempt before another one began. */
    private static final class ShownHelp {
        private Optional<Aids> most = Optional.empty();

        void end(Aids shown) {
            most = Optional.of(shown);
        }

        /** Empty while no other attempt has begun. */
        Optional<Aids> most() {
            return most;
        }
    }

    AttemptRunner(Session session, BackgroundWorker work, RehearsalController controller) {
        this.session = session;
        this.work = work;
        this.controller = controller;
        session.addListener(this);
    }

    /**
     * An attempt whose breath is held or released by an edit begins again, after what else follows from that: the plan
     * that it keeps would not repeat it.
     */
    @Override
    public void onHoldEdited() {
        SwingUtilities.invokeLater(() -> {
            boolean shows = controller.stage() == RehearsalStage.PLAYING;
            if (rehearsal != null && (shows || (controller.stage() == RehearsalStage.READY && !isPlayed))) {
                session.note("The attempt begins again: the breath was held or released without a step of it.");
                controller.startAttempt(shows);
            }
        });
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
        isPlayed = played;
        help.end(controller.pictures().mostHelp());
        ShownHelp shown = new ShownHelp();
        help = shown;
        BooleanSupplier current = work.notDiscardedSince();
        controller.pictures().begin();
        AttemptListener listener = new AttemptListener() {
            @Override
            public void refused(String sentence) {
                SwingUtilities.invokeLater(() -> session.refuse(sentence));
            }

            @Override
            public void finished(LiveAttempt attempt) {
                SwingUtilities.invokeLater(() -> {
                    Aids most = shown.most().orElseGet(controller.pictures()::mostHelp);
                    publishReport(body, about, played ? plan : attempt.toPlan(plan.with(most)), attempt);
                    if (current.getAsBoolean()) {
                        controller.pictures().end();
                        controller.onAttemptEnded(played);
                    }
                });
            }

            @Override
            public void stopped() {
                SwingUtilities.invokeLater(() -> {
                    if (current.getAsBoolean()) {
                        controller.onAttemptEnded(played);
                    }
                });
            }
        };
        Optional<AccessMap> map = played ? Optional.of(about.map()) : Optional.empty();
        LiveRehearsal watching = new LiveRehearsal(
                session.live(), body.simulatedScene(), body.frame(), plan, about.target(), map, listener);
        entry.ifPresent(e -> watching.enterAt(e.restMm(), e.angles()));
        if (!played && controller.probe().hold().isPresent()) {
            watching.holdProbe(controller.probe().hold());
        }
        rehearsal = watching;
        session.restart(
                StepListener.Trigger.every(Rehearsal.FRAME_INTERVAL_S), pictures(watching, body, about, plan, current));
        session.restoreSpeed();
    }

    /** Begins an attempt by hand if a plan has been played, whose needle takes no commands. */
    void takeOver() {
        if (isPlayed && controller.stage() == RehearsalStage.READY) {
            controller.startAttempt(false);
        }
    }

    /** The listener that computes sections and pictures beside the needle. */
    private StepListener pictures(
            LiveRehearsal needle, RehearsalBody body, TargetAccess about, RehearsalPlan plan, BooleanSupplier current) {
        List<Surface> surfaces = body.scene().surfaces();
        SectionUpdater sections = new SectionUpdater(
                sectionThread,
                surfaces,
                body.scene().newFrame().get(),
                (along, across) -> fire(current, l -> l.onSections(along, across)));
        UltrasoundUpdater images = new UltrasoundUpdater(
                pictureThread,
                surfaces,
                about.target(),
                body.scene().newFrame().get(),
                controller.pictures()::latencyS,
                shot -> fire(current, l -> l.onUltrasound(shot)));
        FluoroscopyUpdater xray = new FluoroscopyUpdater(
                new FluoroscopyUpdater.FrameWorkplace(
                        pictureThread, surfaces, body.scene().newFrame().get()),
                about.target(),
                plan.needle(),
                controller.pictures(),
                shot -> fire(current, l -> l.onFluoroscopy(shot)));
        return needle.andThen((frame, label) -> {
            sections.offer(frame, needle.state());
            images.offer(frame, needle.imageMoment(), needle.state());
            xray.offer(frame, needle.state());
        });
    }

    /** Hands on an event of a run that is still the present one. */
    private void fire(BooleanSupplier current, Consumer<RehearsalController.Listener> event) {
        if (current.getAsBoolean()) {
            controller.fire(event);
        }
    }

    /** Composes the report in the background; it is never discarded. */
    private void publishReport(RehearsalBody body, TargetAccess about, RehearsalPlan done, LiveAttempt attempt) {
        publish(() -> attempt.toRehearsal(done, body.surfaces(), about, body.planningScene()));
    }

    /** Hands on the report of a finished attempt once it is composed; a window that is closed meanwhile waits. */
    void publish(Callable<Rehearsal> report) {
        if (closed) {
            return;
        }
        FileWrites composing = FileWrites.begin("the attempt");
        unpublished.add(composing);
        work.runAlways(
                report,
                composed -> endAfter(composing, () -> controller.onReport(composed)),
                problem -> endAfter(composing, () -> session.refuse(problem)));
    }

    private void endAfter(FileWrites composing, Runnable handOn) {
        try {
            handOn.run();
        } finally {
            unpublished.remove(composing);
            composing.end();
        }
    }

    /** Forgets the needle; a sample whose needle is still in the body gives no report, and that is said. */
    void detach() {
        boolean unfinished = isSampleUnreported();
        rehearsal = null;
        if (unfinished) {
            session.note("The attempt has ended without a report: the needle was not out after its sample.");
        }
    }

    /** Whether a needle moved by hand is in the body. */
    boolean isUnderWay() {
        return !isPlayed && state().filter(NeedleState::placed).isPresent();
    }

    /** Whether a sample is taken whose needle is still in the body, so that there is no report yet. */
    boolean isSampleUnreported() {
        return isUnderWay() && state().filter(needle -> needle.samples() > 0).isPresent();
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
        closed = true;
        unpublished.forEach(FileWrites::end);
        unpublished.clear();
        sectionThread.shutdownNow();
        pictureThread.shutdownNow();
    }
}
