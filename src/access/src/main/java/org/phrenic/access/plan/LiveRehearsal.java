package org.phrenic.access.plan;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshots;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.Vectors;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/**
 * A needle in a run that is played live. It looks at the run every {@link Rehearsal#FRAME_INTERVAL_S}, as a plan does;
 * what is asked of it is done at the next look, in order, and written down as the steps of a plan. So an attempt by
 * hand, the plan that it makes, and that plan without a window give the same record, bit for bit. Where the run begins
 * anew, so does the attempt.
 *
 * <p>What is asked may be asked on any thread, and returns at once.
 */
public final class LiveRehearsal implements StepListener {
    /** Told of what happens, on the run's thread. */
    public interface Listener {
        /** What was asked cannot be done, and why. */
        void refused(String sentence);

        /** An attempt has ended: the needle is out after a sample, or the plan was played. */
        void finished(LiveAttempt attempt);
    }

    /** Wall time between two descriptions for a screen, ns. */
    private static final long SHOW_NS = 40_000_000;

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    private final LiveRun run;
    private final MovingAnatomy scene;
    private final Frame ofScene;
    private final RehearsalPlan plan;
    private final TargetLesion target;
    private final Optional<AccessMap> shown;
    private final Listener listener;
    private final PathAnalyzer reader;
    private final Queue<Runnable> requests = new ConcurrentLinkedQueue<>();
    private final ManualStepRecorder steps = new ManualStepRecorder();

    private NeedleInsertion session;
    private NeedleSnapshots views;
    private PlanPlayer player;
    private Optional<double[]> entryRest = Optional.empty();
    private Optional<SkinPoint> entry = Optional.empty();
    private Optional<BreathEvent> holdAt = Optional.empty();
    private double aimedMm;
    private RespiratoryPhase before = RespiratoryPhase.PAUSE;
    private int breathBefore = 1;
    private Frame frame;
    private RespiratoryPhase label = RespiratoryPhase.PAUSE;
    private double timeS;
    private boolean over;
    private long describedNs;
    private volatile NeedleState state;

    /**
     * @param run that is watched, with {@code run.watch(Rehearsal.LOOK_EVERY_S, rehearsal)}
     * @param scene of the run's surfaces; nobody else uses it while this watches
     * @param ofScene a frame of the run's scene; another scene is not looked at
     * @param plan needle and what it should avoid, and the steps if it is to be played
     * @param target what the needle is for
     * @param shown the target's map if the plan is to be played; empty for an attempt by hand
     */
    public LiveRehearsal(
            LiveRun run,
            MovingAnatomy scene,
            Frame ofScene,
            RehearsalPlan plan,
            TargetLesion target,
            Optional<AccessMap> shown,
            Listener listener) {
        this.run = run;
        this.scene = scene;
        this.ofScene = ofScene;
        this.plan = plan;
        this.target = target;
        this.shown = shown;
        this.listener = listener;
        reader = new PathAnalyzer(scene, plan.needle());
    }

    @Override
    public void onStep(Frame shownFrame, RespiratoryPhase doing) {
        if (!shownFrame.isOfSceneOf(ofScene)) {
            return;
        }
        frame = shownFrame;
        label = doing;
        if (session == null || frame.timeS() < timeS) {
            steps.clear();
            begin();
        }
        timeS = frame.timeS();
        int breath = 1 + (int) frame.values()[BREATH];
        session.update(frame, label);
        boolean done = player == null ? runRequests(breath) : play(breath);
        views.observe(session, frame, label);
        before = label;
        breathBefore = breath;
        if (done) {
            listener.finished(new LiveAttempt(
                    player == null ? steps.stepsUntil(timeS) : plan.steps(),
                    target,
                    session.record(),
                    views.all(),
                    timeS,
                    run.commandHash()));
            over = true;
        }
        if (state == null || done || System.nanoTime() - describedNs > SHOW_NS) {
            describedNs = System.nanoTime();
            state = describe(breath);
        }
    }

    private void begin() {
        session = new NeedleInsertion(scene, target, plan.needle(), plan.avoided());
        views = new NeedleSnapshots();
        player =
                shown.map(map -> new PlanPlayer(plan, session, map, this::hold)).orElse(null);
        holdAt = Optional.empty();
        before = RespiratoryPhase.PAUSE;
        breathBefore = 1;
        over = false;
    }

    private boolean play(int breath) {
        requests.clear();
        if (over) {
            return false;
        }
        try {
            return player.update(label, breath);
        } catch (BadInputException bad) {
            over = true;
            listener.refused(bad.getMessage());
            return false;
        }
    }

    /** Says whether the attempt has ended by that. */
    private boolean runRequests(int breath) {
        if (holdAt.isPresent() && holdAt.get().occurs(before, breathBefore, label, breath)) {
            holdAt = Optional.empty();
            held(true);
        }
        for (Runnable next = requests.poll(); next != null; next = requests.poll()) {
            try {
                next.run();
            } catch (BadInputException bad) {
                listener.refused(bad.getMessage());
            }
        }
        return !over && !session.isPlaced() && !session.record().samples().isEmpty();
    }

    private void hold(boolean on, String origin) {
        run.change(List.of(Assignment.of(origin, Breathing.HOLD, on)));
    }

    private void held(boolean on) {
        hold(on, "window");
        steps.held(timeS, on);
    }

    /**
     * Holds the breath when it next comes to its end, of expiration or inspiration; without one lets it go on. A breath
     * that is held goes on first.
     */
    public void holdAt(Optional<BreathEvent.Kind> end) {
        requests.add(() -> {
            holdAt = end.map(kind -> new BreathEvent(kind, OptionalInt.empty()));
            if (run.scenario().hold()) {
                held(false);
            }
        });
    }

    /** Means to go in at a place of the skin, given as it is at end-expiration. Not while the needle is in the body. */
    public void enterAt(double[] onSkinAtRest) {
        requests.add(() -> {
            if (session.isPlaced() && session.depthMm() > 0) {
                throw new BadInputException("entry: found the needle in the body, expected it withdrawn first");
            }
            SkinPoint point = SkinPoint.atRest(scene.skin(), onSkinAtRest);
            entryRest = Optional.of(onSkinAtRest.clone());
            entry = Optional.of(point);
        });
    }

    /**
     * Moves the tip to a depth below the skin. A needle that is not placed is set on the skin first, pointing at where
     * the target is at that moment.
     *
     * @param speedMmPerS more than 0
     */
    public void moveTo(double depthMm, double speedMmPerS) {
        requests.add(() -> {
            if (!session.isPlaced()) {
                place();
            }
            session.advance(depthMm, speedMmPerS);
            steps.moved(timeS, depthMm, speedMmPerS);
        });
    }

    private void place() {
        if (entryRest.isEmpty()) {
            throw new BadInputException("needle: found no entry, expected a place on the skin chosen first");
        }
        if (over) {
            // Another attempt in the same run.
            over = false;
            steps.keepBreathHolds();
            session = new NeedleInsertion(scene, target, plan.needle(), plan.avoided());
            views = new NeedleSnapshots();
            session.update(frame, label);
        }
        double[] aim = session.targetNow();
        session.placeAtRest(entryRest.get(), aim);
        steps.placed(timeS, entryRest.get());
        aimedMm = Vectors.distance(session.entryNow(), aim);
    }

    /** Points the needle at where the target is now; it turns about its place in the skin. */
    public void aim() {
        requests.add(() -> {
            double[] aim = session.targetNow();
            session.redirect(aim);
            steps.redirected(timeS);
            aimedMm = Vectors.distance(session.entryNow(), aim);
        });
    }

    /** Takes a sample where the tip is. */
    public void sample() {
        requests.add(() -> {
            session.sample();
            steps.sampled(timeS);
        });
    }

    private NeedleState describe(int breath) {
        double[] at = session.targetNow();
        boolean placed = session.isPlaced();
        Optional<double[]> from = placed ? Optional.of(session.entryNow()) : entry.map(SkinPoint::current);
        double[] start = from.orElse(at);
        double aimed = placed ? Math.max(aimedMm, session.depthMm()) : Vectors.distance(start, at);
        double[] direction = placed
                ? session.directionNow()
                : aimed > 0 ? Vectors.normalize(Vectors.subtract(at, start)) : new double[] {0, 0, 1};
        double[] end = Vectors.addScaled(start, direction, aimed);
        Optional<PathAnalysis> path = from.map(skin -> reader.analyze(skin, end));
        double margin = path.isPresent() ? reader.margin(start, end, plan.avoided()) : 0;
        double depth = placed ? session.depthMm() : 0;
        return new NeedleState(
                timeS,
                breath,
                label,
                at,
                target.radiusMm(),
                from,
                placed,
                Vectors.addScaled(start, direction, depth - plan.needle().lengthMm()),
                Vectors.addScaled(start, direction, depth),
                depth,
                aimed,
                session.isInLiver(),
                session.isMoving(),
                placed ? Optional.of(session.targetingError()) : Optional.empty(),
                path,
                path.map(p -> p.reasons(plan.avoided())).orElse(List.of()),
                margin,
                path.isPresent() ? scene.labelOf(reader.nearestOfMargin()) : "",
                placed ? session.warnings() : List.of(),
                session.record().samples().size(),
                holdAt.map(BreathEvent::text).orElse(""),
                player != null);
    }

    /** How it stands; null before the first look. */
    public NeedleState state() {
        return state;
    }
}
