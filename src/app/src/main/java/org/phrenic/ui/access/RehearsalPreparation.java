package org.phrenic.ui.access;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;

/**
 * From a body to a needle that may be used: a breath is looked at, then the access map of the target worked out, beside
 * the window. On the event dispatch thread.
 */
final class RehearsalPreparation {
    /** Told on the event dispatch thread. */
    interface Listener {
        /** The run is not to be watched by anyone from before, nor is what was begun for it wanted. */
        void detachRun();

        /** The target at hand, and the way to it, count no more. */
        void clearEntry();

        /** Something is no longer what it was. */
        void onChange();

        /** An attempt may begin. */
        void onReady();
    }

    private final Session session;
    private final AppearanceModel appearance;
    private final BackgroundWorker work;
    private final ObservedRun run;
    private final BreathCapture look;
    private final TargetSelection targets;
    private final Listener listener;

    private RehearsalStage stage = RehearsalStage.CLOSED;
    private String unavailableReason = "";
    private double recordedFraction;
    private Optional<RehearsalBody> body = Optional.empty();

    RehearsalPreparation(
            Session session,
            AppearanceModel appearance,
            BackgroundWorker work,
            ObservedRun run,
            TargetSelection targets,
            Listener told) {
        this.session = session;
        this.appearance = appearance;
        this.work = work;
        this.run = run;
        this.targets = targets;
        this.listener = told;
        look = new BreathCapture(session, run);
    }

    /** A body is being built. */
    void onBodyLoading() {
        stage = RehearsalStage.LOADING;
        listener.detachRun();
        listener.onChange();
    }

    /** A body is there. */
    void setBody(LiveScene now) {
        stage = RehearsalStage.LOADING;
        listener.detachRun();
        body = Optional.empty();
        look.clear();
        clearTarget();
        appearance.overrideStyle(style -> style, Optional.empty());
        listener.onChange();
        work.run(
                () -> RehearsalBody.of(now),
                built -> {
                    body = Optional.of(built);
                    look();
                },
                this::onFailure);
    }

    private void clearTarget() {
        targets.clear();
        listener.clearEntry();
    }

    /** Another breathing than was looked at is looked at anew. */
    void recordBreathIfChanged() {
        if ((stage.canStartAttempt() || stage == RehearsalStage.MAPPING) && !look.matchesCurrent()) {
            look();
        }
    }

    /** Has the run's first breath looked at. */
    private void look() {
        listener.detachRun();
        stage = RehearsalStage.RECORDING_BREATH;
        recordedFraction = 0;
        look.markCurrentBreathing();
        // Another breathing than the exercise's: its target stays, to practise on.
        targets.setExercise(targets.exercise().filter(asked -> look.matches(asked.scenario())));
        look.start(
                body.orElseThrow().frame(),
                targets.exercise().map(RehearsalPlan::moments).orElse(BreathCycle.PHASES),
                work.notDiscardedSince(),
                done -> {
                    recordedFraction = done;
                    listener.onChange();
                },
                this::computeMap);
        listener.onChange();
    }

    private void computeMap() {
        computeMap(targets.current(body.orElseThrow()));
    }

    /** Works out from where a target can be reached. */
    void computeMap(Callable<TargetLesion> where) {
        listener.detachRun();
        stage = RehearsalStage.MAPPING;
        run.restoreUserSpeed();
        listener.onChange();
        RehearsalBody of = body.orElseThrow();
        Scenario scenario = session.scenario().with("hold=false");
        List<BreathMoment> breath = look.cycle();
        Optional<RehearsalPlan> asked = targets.exercise();
        work.run(
                () -> of.studyTarget(where.call(), breath, asked, scenario),
                made -> {
                    targets.setStudied(made);
                    appearance.overrideStyle(made.colours()::applyTo, Optional.of(made.colours()));
                    listener.clearEntry();
                    listener.onReady();
                },
                this::onFailure);
    }

    private void onFailure(String sentence) {
        if (stage == RehearsalStage.MAPPING && targets.exercise().isPresent()) {
            targets.setExercise(Optional.empty());
            targets.clear();
            computeMap();
        } else if (stage == RehearsalStage.LOADING
                || (stage == RehearsalStage.MAPPING && targets.study().isEmpty())) {
            stage = RehearsalStage.UNAVAILABLE;
            unavailableReason = sentence;
        } else if (stage == RehearsalStage.MAPPING) {
            listener.onReady();
        }
        session.refuse(sentence);
        listener.onChange();
    }

    /** Practises on the body as it is. */
    void startPractice() {
        if (targets.exercise().isPresent()) {
            targets.setExercise(Optional.empty());
            clearTarget();
            if (stage != RehearsalStage.LOADING && !look.cycle().isEmpty()) {
                computeMap();
            }
        }
    }

    /** Opens an exercise: its body breathes as it says, and its target is there. */
    void open(RehearsalPlan other) {
        targets.setExercise(Optional.of(other));
        clearTarget();
        if (body.isPresent() && stage != RehearsalStage.LOADING && look.isCurrentBreathing(other.scenario())) {
            look();
        } else {
            onBodyLoading();
            session.open("Exercise " + other.title(), other.scenario());
        }
    }

    RehearsalStage stage() {
        return stage;
    }

    /** An attempt begins, or nobody is here any more. */
    void setStage(RehearsalStage now) {
        stage = now;
    }

    /** Why nothing can be rehearsed on this body. */
    String unavailableReason() {
        return unavailableReason;
    }

    /** How much of the breath was looked at. */
    double recordedFraction() {
        return recordedFraction;
    }

    Optional<RehearsalBody> body() {
        return body;
    }
}
