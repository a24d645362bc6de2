package org.phrenic.ui.access;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.CycleRecorder;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.ScannedLesion;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.anatomy.Resolution;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.Session;

/**
 * The stages before an attempt: the body is loaded, one breath is recorded, the target is placed and its access map
 * computed in the background. Used on the event dispatch thread.
 */
final class RehearsalPreparation {
    private static final double DEPTH_BELOW_SURFACE_MM = 35;
    private static final double DEFAULT_DIAMETER_MM = 20;
    private static final long SEED = 1;
    /** No scene has this number. */
    private static final long NO_SCENE = -1;

    /** What is rehearsed; an exercise has its own target. */
    private record Rehearsed(Optional<RehearsalPlan> exercise, Aids aids, Optional<TargetLesion> target) {}

    private final Session session;
    private final BackgroundWorker worker;
    private final RehearsalController rehearsal;
    private Scenario recorded = Scenario.defaults();
    private boolean setsRepetition;
    private RehearsalBody.Recorded cycle = RehearsalBody.Recorded.NONE;
    private long sceneId = NO_SCENE;
    /** What is rehearsed again if the scene of another exercise does not come; empty while none is waited for. */
    private Optional<Rehearsed> former = Optional.empty();
    /** The target that comes again with a scene that stays. */
    private Optional<TargetLesion> keptTarget = Optional.empty();

    /** The exercise that was left with its breath, and that comes again with it. */
    private Optional<RehearsalPlan> left = Optional.empty();

    private double diameterMm = DEFAULT_DIAMETER_MM;

    RehearsalPreparation(Session session, BackgroundWorker worker, RehearsalController rehearsal) {
        this.session = session;
        this.worker = worker;
        this.rehearsal = rehearsal;
    }

    void awaitBody() {
        enter(RehearsalStage.LOADING);
        rehearsal.fireState();
    }

    private void enter(RehearsalStage stage) {
        rehearsal.detachRun();
        rehearsal.stage = stage;
        rehearsal.pickMode().cancel();
        // The recording of a breath may have been flat out.
        session.restoreSpeed();
    }

    /** Begins on a scene; on one that stays, since no other has come, with what was rehearsed on it before. */
    void setBody(LiveScene scene) {
        enter(RehearsalStage.LOADING);
        rehearsal.body = Optional.empty();
        cycle = RehearsalBody.Recorded.NONE;
        Rehearsed before = former.orElseGet(this::rehearsed);
        clearTarget();
        if (scene.id() == sceneId) {
            rehearsal.exercise = before.exercise();
            rehearsal.setAids(before.aids());
            keptTarget = before.target();
        }
        former = Optional.empty();
        sceneId = scene.id();
        rehearsal.fireState();
        worker.run(
                () -> RehearsalBody.of(scene),
                body -> {
                    rehearsal.body = Optional.of(body);
                    recordBreath();
                },
                this::onFailure);
    }

    private Rehearsed rehearsed() {
        Optional<TargetLesion> target =
                rehearsal.study.map(TargetAccess::target).or(() -> keptTarget);
        return new Rehearsed(rehearsal.exercise, rehearsal.pictures().aids(), target);
    }

    /** Forgets the target, its access map and the entry, and takes the map off the skin. */
    private void clearTarget() {
        rehearsal.study = Optional.empty();
        keptTarget = Optional.empty();
        rehearsal.colours = Optional.empty();
        rehearsal.entrySelection().clear();
        rehearsal.showBody();
    }

    /**
     * Records the breath again if the breathing is not the recorded one. A record that a change, or a hold, has come
     * into is not that of a breath, also after the change is undone.
     */
    void recordBreathIfChanged() {
        boolean recording = rehearsal.stage == RehearsalStage.RECORDING_BREATH;
        boolean used = rehearsal.body.isPresent()
                && (recording || rehearsal.stage.canStartAttempt() || rehearsal.stage == RehearsalStage.MAPPING);
        boolean held = recording && session.scenario().hold();
        if (used && (held || !breatheAlike(recorded, session.scenario()))) {
            recordBreath();
        }
    }

    /**
     * With other breathing than the exercise's it is practised, on the target of the exercise unless another scene has
     * come, until that breathing comes again.
     */
    void followBreathing(Scenario present) {
        boolean exercised = rehearsal.exercise.isPresent();
        left = rehearsal.exercise.or(() -> left);
        rehearsal.exercise = left.filter(exercise -> breatheAlike(exercise.scenario(), present));
        if (exercised && rehearsal.exercise.isEmpty()) {
            String target = rehearsed().target().isPresent() ? "its target" : "another target";
            session.note("The exercise has another breath: practice on " + target + "; Undo goes back to it.");
        }
    }

    private void recordBreath() {
        enter(RehearsalStage.RECORDING_BREATH);
        cycle = RehearsalBody.Recorded.NONE;
        rehearsal.entrySelection().clear();
        rehearsal.recordedFraction = 0;
        followBreathing(session.scenario());
        // The needle does not move the body, so a steady breath need not be simulated again, if no exercise asks for
        // it.
        repeatSteadyBreath(rehearsal
                .exercise
                .map(exercise -> exercise.scenario().get(Breathing.REPEAT))
                .orElse(true));
        int phases = rehearsal.exercise.map(RehearsalPlan::moments).orElse(BreathCycle.PHASES);
        Frame frame = rehearsal.body.orElseThrow().frame();
        BooleanSupplier wanted = worker.notDiscardedSince();
        recorded = session.scenario();
        CycleRecorder recorder = new CycleRecorder(
                session.live(),
                frame,
                phases,
                fraction -> onEventThread(wanted, () -> {
                    rehearsal.recordedFraction = fraction;
                    rehearsal.fireState();
                }),
                whole -> onEventThread(wanted, () -> {
                    cycle = new RehearsalBody.Recorded(whole, phases);
                    computeMap();
                }));
        session.live().setSpeed(Double.POSITIVE_INFINITY);
        session.restart(recorder, recorder);
        rehearsal.fireState();
    }

    /** Repeats steady breaths from their record until {@link #endRepetition}, or simulates each. */
    private void repeatSteadyBreath(boolean repeated) {
        boolean changes = session.scenario().get(Breathing.REPEAT) != repeated;
        setsRepetition = repeated && (setsRepetition || changes);
        if (changes) {
            setRepetition(repeated);
        }
    }

    /** Simulates every breath again if the rehearsal has begun to repeat them. */
    void endRepetition() {
        if (setsRepetition && session.scenario().get(Breathing.REPEAT)) {
            setRepetition(false);
        }
        setsRepetition = false;
    }

    /** A scenario without what the rehearsal itself has set. */
    Scenario ofUser(Scenario scenario) {
        return setsRepetition ? scenario.without(Breathing.REPEAT) : scenario;
    }

    private void setRepetition(boolean on) {
        session.live().change(List.of(Assignment.of("rehearsal", Breathing.REPEAT, on)));
    }

    private static void onEventThread(BooleanSupplier wanted, Runnable what) {
        SwingUtilities.invokeLater(() -> {
            if (wanted.getAsBoolean()) {
                what.run();
            }
        });
    }

    /** Whether two scenarios are the same but for a breath hold and the repetition of steady breaths. */
    private static boolean breatheAlike(Scenario one, Scenario other) {
        return breathing(one).equals(breathing(other));
    }

    private static Scenario breathing(Scenario scenario) {
        return scenario.with("hold=false", "repeat_breath=true");
    }

    /** Computes the map of the exercise's target, of the present one, of the largest lesion, or of one at random. */
    private void computeMap() {
        RehearsalBody body = rehearsal.body.orElseThrow();
        Optional<RehearsalPlan> exercise = rehearsal.exercise;
        Optional<TargetLesion> present = rehearsed().target();
        double size = diameterMm;
        computeMap(() -> exercise.isPresent()
                ? exercise.get().target(body.planningScene())
                : present.orElseGet(() -> practiceTarget(body.planningScene(), body.lesions(), size)));
    }

    /** The largest lesion, or a target at random that is as large as wished if the liver has room for it. */
    static TargetLesion practiceTarget(MovingAnatomy scene, List<ScannedLesion> lesions, double diameterMm) {
        return lesions.stream()
                .findFirst()
                .map(ScannedLesion::target)
                .orElseGet(() -> TargetLesion.randomUpTo(scene, SEED, diameterMm));
    }

    private void computeMap(Callable<TargetLesion> target) {
        enter(RehearsalStage.MAPPING);
        rehearsal.fireState();
        RehearsalBody body = rehearsal.body.orElseThrow();
        Scenario scenario = session.scenario().with("hold=false");
        RehearsalBody.Recorded breath = cycle;
        Optional<RehearsalPlan> exercise = rehearsal.exercise;
        worker.run(
                () -> body.studyTarget(target.call(), breath, exercise, scenario),
                studied -> {
                    rehearsal.plan = Optional.of(studied.plan());
                    rehearsal.study = Optional.of(studied.study());
                    rehearsal.colours = Optional.of(studied.colours());
                    rehearsal.showBody();
                    rehearsal.entrySelection().clear();
                    rehearsal.startAttempt(false);
                },
                this::onFailure);
    }

    private void onFailure(String sentence) {
        boolean mapping = rehearsal.stage == RehearsalStage.MAPPING;
        if (mapping && rehearsal.exercise.isPresent()) {
            left = Optional.empty();
            rehearsal.exercise = Optional.empty();
            clearTarget();
            computeMap();
        } else if (rehearsal.stage == RehearsalStage.LOADING || (mapping && rehearsal.study.isEmpty())) {
            rehearsal.stage = RehearsalStage.UNAVAILABLE;
            rehearsal.unavailableReason = sentence;
        } else if (mapping) {
            rehearsal.startAttempt(false);
        }
        session.refuse(sentence);
        rehearsal.fireState();
    }

    void startPractice() {
        left = Optional.empty();
        if (rehearsal.exercise.isPresent()) {
            rehearsal.exercise = Optional.empty();
            former = Optional.empty();
            clearTarget();
            if (rehearsal.stage != RehearsalStage.LOADING && cycle.phases() > 0) {
                computeMap();
            }
        }
    }

    private static String name(Resolution resolution) {
        return resolution.name().toLowerCase(Locale.ROOT);
    }

    private void noteResolution(Scenario exercise) {
        Resolution present = session.scenario().resolution();
        if (exercise.resolution() != present) {
            session.note("The exercise runs at " + name(exercise.resolution()) + " resolution; the scene before had "
                    + name(present) + ".");
        }
    }

    void open(RehearsalPlan exercise) {
        Rehearsed before = former.orElseGet(this::rehearsed);
        former = Optional.empty();
        rehearsal.exercise = Optional.of(exercise);
        rehearsal.pictures().setAids(exercise.aids());
        clearTarget();
        boolean loaded = rehearsal.body.isPresent() && rehearsal.stage != RehearsalStage.LOADING;
        if (loaded && breatheAlike(session.scenario(), exercise.scenario())) {
            recordBreath();
        } else {
            former = Optional.of(before);
            noteResolution(exercise.scenario());
            awaitBody();
            session.open(EditName.of("Exercise " + exercise.title()), exercise.scenario());
            // The loading may end before any of its progress is told.
            rehearsal.awaitsScene = true;
        }
    }

    /** Sets a target as large as the present one below a place of the liver's surface. */
    void setTargetBehind(PickResult pick) {
        if (rehearsal.stage != RehearsalStage.READY) {
            return;
        }
        RehearsalBody body = rehearsal.body.orElseThrow();
        double size = rehearsal.study.orElseThrow().target().diameterMm();
        computeMap(() -> TargetLesion.behindSurface(
                body.planningScene(), pick.restPosition(), pick.rayDirection(), DEPTH_BELOW_SURFACE_MM, size));
    }

    void setTarget(TargetLesion target) {
        if (rehearsal.stage != RehearsalStage.READY) {
            return;
        }
        left = Optional.empty();
        computeMap(() -> target);
    }

    void setTargetMm(double mm) {
        diameterMm = mm;
        boolean ready = rehearsal.stage == RehearsalStage.READY && rehearsal.exercise.isEmpty();
        if (ready && rehearsal.study.isPresent()) {
            RehearsalBody body = rehearsal.body.orElseThrow();
            double[] at = rehearsal.study.get().target().restMm();
            left = Optional.empty();
            computeMap(() -> TargetLesion.at(body.planningScene(), at, mm));
        }
    }
}
