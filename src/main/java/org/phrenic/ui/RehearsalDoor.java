package org.phrenic.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.phrenic.rehearsal.LiveRehearsal;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.scene.NeedleMarks;
import org.phrenic.scene.Pick;
import org.phrenic.scene.Section;
import org.phrenic.scene.View;
import org.phrenic.simulation.live.LiveScene;

/**
 * The clinician's door: what is rehearsed on the body that breathes in the window. It has the run's first breath looked at, the access map worked out beside the window, and then puts a needle into the run that
 * does what is asked. On the event dispatch thread; nothing here waits.
 */
final class RehearsalDoor implements Session.Events {
    /** Liver access is from the right. */
    private static final double FROM_RIGHT_DEG = -52;

    private static final double FROM_ABOVE_DEG = 6;

    private final Session session;
    private final Looks looks;
    private final SceneView view;
    private final List<DoorEvents> listeners = new ArrayList<>();
    private final Background work = new Background("phrenic-rehearsal");
    private final WatchedRun run;
    private final TargetChoice targets = new TargetChoice();
    private final Preparation preparation;
    private final AttemptRun attempt;
    private final WayIn way;
    private final ClickChoice clicks;
    private final NeedleHand hand;
    private boolean seenFromRight;

    RehearsalDoor(Session session, Looks looks, SceneView view) {
        this.session = session;
        this.looks = looks;
        this.view = view;
        run = new WatchedRun(session);
        preparation = new Preparation(session, looks, work, run, targets, new FromPreparation());
        attempt = new AttemptRun(session, run, work, new FromAttempt());
        way = new WayIn(session, this, work);
        clicks = new ClickChoice(session, this, view);
        hand = new NeedleHand(session, this, view);
        view.setTool(Optional.of(new NeedleTool(this)));
        session.listen(this);
    }

    void listen(DoorEvents listener) {
        listeners.add(listener);
    }

    /** Forgets a listener. */
    void forget(DoorEvents listener) {
        listeners.remove(listener);
    }

    /** Tells all listeners that something is no longer what it was. */
    void tell() {
        listeners.forEach(DoorEvents::onDoor);
    }

    /** Someone comes in. */
    void open() {
        if (!isOpen()) {
            preparation.setStage(DoorStage.LOADING);
            session.follow();
            view.mark(() -> attempt.state().map(state -> new NeedleMarks(state, way.level(state))));
            session.scene().ifPresentOrElse(this::enter, this::tell);
        }
    }

    /** Someone goes to the other door; the body breathes on. */
    void close() {
        if (isOpen()) {
            preparation.setStage(DoorStage.CLOSED);
            clicks.choose(ClickChoice.Of.NOTHING);
            leaveRun();
            run.atSpeed();
            view.mark(Optional::empty);
            looks.dress(style -> style, Optional.empty());
        }
    }

    boolean isOpen() {
        return stage() != DoorStage.CLOSED;
    }

    private void leaveRun() {
        run.leave();
        work.drop();
        attempt.leave();
    }

    /** Ends its threads. */
    void end() {
        leaveRun();
        work.close();
        attempt.close();
    }

    @Override
    public void onLoading(String what, double howFar) {
        if (isOpen() && stage() != DoorStage.LOADING) {
            preparation.awaitBody();
        }
    }

    @Override
    public void onScene(LiveScene now) {
        if (isOpen()) {
            enter(now);
        }
    }

    @Override
    public void onChange() {
        preparation.lookAgain();
    }

    private void enter(LiveScene now) {
        if (!seenFromRight) {
            seenFromRight = true;
            // The view has taken the scene over by then.
            SwingUtilities.invokeLater(
                    () -> view.setCamera(view.camera().seen(View.ANTERIOR).orbit(FROM_RIGHT_DEG, FROM_ABOVE_DEG)));
        }
        preparation.enter(now);
    }

    /** A new attempt from the start of the run; by hand, or by the steps of the exercise. */
    private void begin(boolean played) {
        leaveRun();
        preparation.setStage(played ? DoorStage.SHOWING : DoorStage.READY);
        attempt.begin(
                body().orElseThrow(),
                study().orElseThrow(),
                (played ? exercise() : plan()).orElseThrow(),
                played,
                way.entry());
        listeners.forEach(DoorEvents::onBegin);
        tell();
    }

    /** Practises on the body as it is. */
    void practise() {
        preparation.practise();
    }

    /** Opens an exercise: its body breathes as it says, and its target is there. */
    void open(RehearsalPlan other) {
        preparation.open(other);
    }

    /** From the start again, with the same target and entry. */
    void retry() {
        if (study().isPresent() && stage().mayBegin()) {
            begin(false);
        }
    }

    /** Plays the exercise as it ships. */
    void demonstrate() {
        if (exercise().isPresent() && study().isPresent() && stage().mayBegin()) {
            way.forget();
            begin(true);
        }
    }

    /** A target behind the place of the liver that was clicked on. */
    void targetBehind(Pick pick) {
        preparation.map(targets.behind(body().orElseThrow(), pick));
    }

    /** Another size of the target, in the same place. */
    void setTargetMm(double diameterMm) {
        targets.setDiameterMm(diameterMm);
        if (stage() == DoorStage.READY && exercise().isEmpty() && study().isPresent()) {
            preparation.map(targets.resized(body().orElseThrow()));
        }
    }

    /** What moves the needle. */
    NeedleHand hand() {
        return hand;
    }

    /** Where the needle goes in. */
    WayIn way() {
        return way;
    }

    /** What clicks choose. */
    ClickChoice clicks() {
        return clicks;
    }

    /** The needle in the run; empty unless it may be used. */
    Optional<LiveRehearsal> usable() {
        return stage() == DoorStage.READY ? attempt.rehearsal() : Optional.empty();
    }

    DoorStage stage() {
        return preparation.stage();
    }

    /** What is said of a body on which nothing can be rehearsed. */
    String impossible() {
        return preparation.impossible();
    }

    /** How much of the breath was looked at. */
    double share() {
        return preparation.share();
    }

    Optional<RehearsalPlan> exercise() {
        return targets.exercise();
    }

    /** What is rehearsed, exercise or practice. */
    Optional<RehearsalPlan> plan() {
        return targets.plan();
    }

    Optional<RehearsedBody> body() {
        return preparation.body();
    }

    Optional<TargetStudy> study() {
        return targets.study();
    }

    Optional<NeedleState> state() {
        return attempt.state();
    }

    /** What the preparation wants done with the rest of the door. */
    private final class FromPreparation implements Preparation.Told {
        @Override
        public void leave() {
            leaveRun();
        }

        @Override
        public void forgetWay() {
            way.forget();
        }

        @Override
        public void changed() {
            tell();
        }

        @Override
        public void ready() {
            begin(false);
        }
    }

    /** What an attempt tells goes to whom it may concern. */
    private final class FromAttempt implements AttemptRun.Told {
        @Override
        public void refused(String sentence) {
            session.say(Session.Message.Kind.REFUSED, sentence);
        }

        @Override
        public void cut(Section along, Section across) {
            listeners.forEach(l -> l.onSections(along, across));
        }

        @Override
        public void over(boolean played) {
            if (played) {
                preparation.setStage(DoorStage.READY);
                tell();
            }
        }

        @Override
        public void reported(Rehearsal rehearsal) {
            listeners.forEach(l -> l.onAttempt(rehearsal));
            tell();
        }
    }
}
