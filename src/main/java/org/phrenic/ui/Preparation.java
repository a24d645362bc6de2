package org.phrenic.ui;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.rehearsal.BreathCycle;
import org.phrenic.rehearsal.BreathMoment;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.Target;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.LiveScene;

/** From a body to a needle that may be used: a breath is looked at, then the access map of the target worked out, beside the window. On the event dispatch thread. */
final class Preparation {
    /** Told on the event dispatch thread. */
    interface Told {
        /** The run is not to be watched by anyone from before, nor is what was begun for it wanted. */
        void leave();

        /** The target at hand, and the way to it, count no more. */
        void forgetWay();

        /** Something is no longer what it was. */
        void changed();

        /** An attempt may begin. */
        void ready();
    }

    private final Session session;
    private final Looks looks;
    private final Background work;
    private final WatchedRun run;
    private final BreathLook look;
    private final TargetChoice targets;
    private final Told told;

    private DoorStage stage = DoorStage.CLOSED;
    private String impossible = "";
    private double share;
    private Optional<RehearsedBody> body = Optional.empty();

    Preparation(Session session, Looks looks, Background work, WatchedRun run, TargetChoice targets, Told told) {
        this.session = session;
        this.looks = looks;
        this.work = work;
        this.run = run;
        this.targets = targets;
        this.told = told;
        look = new BreathLook(session, run);
    }

    /** A body is being built. */
    void awaitBody() {
        stage = DoorStage.LOADING;
        told.leave();
        told.changed();
    }

    /** A body is there. */
    void enter(LiveScene now) {
        stage = DoorStage.LOADING;
        told.leave();
        body = Optional.empty();
        look.forget();
        forgetTarget();
        looks.dress(style -> style, Optional.empty());
        told.changed();
        work.run(
                () -> RehearsedBody.of(now),
                built -> {
                    body = Optional.of(built);
                    look();
                },
                this::refuse);
    }

    private void forgetTarget() {
        targets.forget();
        told.forgetWay();
    }

    /** Another breathing than was looked at is looked at anew. */
    void lookAgain() {
        if ((stage.mayBegin() || stage == DoorStage.MAPPING) && !look.isOfNow()) {
            look();
        }
    }

    /** Has the run's first breath looked at. */
    private void look() {
        told.leave();
        stage = DoorStage.LOOKING;
        share = 0;
        look.remember();
        // Another breathing than the exercise's: its target stays, to practise on.
        targets.setExercise(targets.exercise().filter(asked -> look.isOf(asked.scenario())));
        look.begin(
                body.orElseThrow().frame(),
                targets.exercise().map(RehearsalPlan::phases).orElse(BreathCycle.PHASES),
                work.current(),
                done -> {
                    share = done;
                    told.changed();
                },
                this::map);
        told.changed();
    }

    private void map() {
        map(targets.usual(body.orElseThrow()));
    }

    /** Works out from where a target can be reached. */
    void map(Callable<Target> where) {
        told.leave();
        stage = DoorStage.MAPPING;
        run.atSpeed();
        told.changed();
        RehearsedBody of = body.orElseThrow();
        Scenario scenario = session.scenario().with("hold=false");
        List<BreathMoment> breath = look.cycle();
        Optional<RehearsalPlan> asked = targets.exercise();
        work.run(
                () -> of.study(where.call(), breath, asked, scenario),
                made -> {
                    targets.take(made);
                    looks.dress(made.colours()::shown, Optional.of(made.colours()));
                    told.forgetWay();
                    told.ready();
                },
                this::refuse);
    }

    private void refuse(String sentence) {
        if (stage == DoorStage.MAPPING && targets.exercise().isPresent()) {
            targets.setExercise(Optional.empty());
            targets.forget();
            map();
        } else if (stage == DoorStage.LOADING
                || (stage == DoorStage.MAPPING && targets.study().isEmpty())) {
            stage = DoorStage.IMPOSSIBLE;
            impossible = sentence;
        } else if (stage == DoorStage.MAPPING) {
            told.ready();
        }
        session.say(Session.Message.Kind.REFUSED, sentence);
        told.changed();
    }

    /** Practises on the body as it is. */
    void practise() {
        if (targets.exercise().isPresent()) {
            targets.setExercise(Optional.empty());
            forgetTarget();
            if (stage != DoorStage.LOADING && !look.cycle().isEmpty()) {
                map();
            }
        }
    }

    /** Opens an exercise: its body breathes as it says, and its target is there. */
    void open(RehearsalPlan other) {
        targets.setExercise(Optional.of(other));
        forgetTarget();
        if (body.isPresent() && stage != DoorStage.LOADING && look.isNow(other.scenario())) {
            look();
        } else {
            awaitBody();
            session.open("Exercise " + other.title(), other.scenario());
        }
    }

    DoorStage stage() {
        return stage;
    }

    /** An attempt begins, or nobody is here any more. */
    void setStage(DoorStage now) {
        stage = now;
    }

    /** Why nothing can be rehearsed on this body. */
    String impossible() {
        return impossible;
    }

    /** How much of the breath was looked at. */
    double share() {
        return share;
    }

    Optional<RehearsedBody> body() {
        return body;
    }
}
