package org.phrenic.rehearsal;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.phrenic.breathing.BreathLabel;
import org.phrenic.format.BadInputException;
import org.phrenic.geometry.Vectors;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.Watch;

/**
 * A needle in a run that is played live. It looks at the run every {@link Rehearsal#LOOK_EVERY_S}, as a plan does; what is asked of it is done at the next look, in order, and written down as the steps of a plan. So an attempt by hand,
 * the plan that it makes, and that plan without a window give the same record, bit for bit. Where the run begins anew, so does the attempt.
 *
 * <p>What is asked may be asked on any thread, and returns at once.
 */
public final class LiveRehearsal implements Watch {
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
    private final MovingScene scene;
    private final Frame ofScene;
    private final RehearsalPlan plan;
    private final Target target;
    private final Optional<AccessMap> shown;
    private final Listener listener;
    private final PathReader reader;
    private final Queue<Runnable> asked = new ConcurrentLinkedQueue<>();
    private final HandSteps steps = new HandSteps();

    private NeedleSession session;
    private NeedleViews views;
    private PlanPlayer player;
    private Optional<double[]> entryRest = Optional.empty();
    private Optional<SkinPoint> entry = Optional.empty();
    private Optional<BreathEvent> holdAt = Optional.empty();
    private double aimedMm;
    private BreathLabel before = BreathLabel.PAUSE;
    private int breathBefore = 1;
    private Frame frame;
    private BreathLabel label = BreathLabel.PAUSE;
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
            MovingScene scene,
            Frame ofScene,
            RehearsalPlan plan,
            Target target,
            Optional<AccessMap> shown,
            Listener listener) {
        this.run = run;
        this.scene = scene;
        this.ofScene = ofScene;
        this.plan = plan;
        this.target = target;
        this.shown = shown;
        this.listener = listener;
        reader = new PathReader(scene, plan.needle());
    }

    @Override
    public void see(Frame shownFrame, BreathLabel doing) {
        if (!shownFrame.isOfSceneOf(ofScene)) {
            return;
        }
        frame = shownFrame;
        label = doing;
        if (session == null || frame.timeS() < timeS) {
            steps.forget();
            begin();
        }
        timeS = frame.timeS();
        int breath = 1 + (int) frame.values()[BREATH];
        session.take(frame, label);
        boolean done = player == null ? doWhatIsAsked(breath) : play(breath);
        views.look(session, frame, label);
        before = label;
        breathBefore = breath;
        if (done) {
            listener.finished(new LiveAttempt(
                    player == null ? steps.until(timeS) : plan.steps(),
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
        session = new NeedleSession(scene, target, plan.needle(), plan.avoided());
        views = new NeedleViews();
        player =
                shown.map(map -> new PlanPlayer(plan, session, map, this::hold)).orElse(null);
        holdAt = Optional.empty();
        before = BreathLabel.PAUSE;
        breathBefore = 1;
        over = false;
    }

    private boolean play(int breath) {
        asked.clear();
        if (over) {
            return false;
        }
        try {
            return player.look(label, breath);
        } catch (BadInputException bad) {
            over = true;
            listener.refused(bad.getMessage());
            return false;
        }
    }

    /** Says whether the attempt has ended by that. */
    private boolean doWhatIsAsked(int breath) {
        if (holdAt.isPresent() && holdAt.get().happens(before, breathBefore, label, breath)) {
            holdAt = Optional.empty();
            held(true);
        }
        for (Runnable next = asked.poll(); next != null; next = asked.poll()) {
            try {
                next.run();
            } catch (BadInputException bad) {
                listener.refused(bad.getMessage());
            }
        }
        return !over && !session.isPlaced() && !session.record().samples().isEmpty();
    }

    private void hold(boolean on, String origin) {
        run.change(List.of(new Assignment(origin, "hold", Boolean.toString(on))));
    }

    private void held(boolean on) {
        hold(on, "window");
        steps.held(timeS, on);
    }

    /** Holds the breath when it next comes to its end, of expiration or inspiration; without one lets it go on. A breath that is held goes on first. */
    public void holdAt(Optional<BreathEvent.Kind> end) {
        asked.add(() -> {
            holdAt = end.map(kind -> new BreathEvent(kind, OptionalInt.empty()));
            if (run.scenario().hold()) {
                held(false);
            }
        });
    }

    /** Means to go in at a place of the skin, given as it is at end-expiration. Not while the needle is in the body. */
    public void enterAt(double[] onSkinAtRest) {
        asked.add(() -> {
            if (session.isPlaced() && session.depthMm() > 0) {
                throw new BadInputException("entry: found the needle in the body, expected it withdrawn first");
            }
            SkinPoint point = SkinPoint.atRest(scene.skin(), onSkinAtRest);
            entryRest = Optional.of(onSkinAtRest.clone());
            entry = Optional.of(point);
        });
    }

    /**
     * Moves the tip to a depth below the skin. A needle that is not placed is set on the skin first, pointing at where the target is at that moment.
     *
     * @param speedMmPerS more than 0
     */
    public void moveTo(double depthMm, double speedMmPerS) {
        asked.add(() -> {
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
            steps.keepBreathing();
            session = new NeedleSession(scene, target, plan.needle(), plan.avoided());
            views = new NeedleViews();
            session.take(frame, label);
        }
        double[] aim = session.targetNow();
        session.placeAtRest(entryRest.get(), aim);
        steps.placed(timeS, entryRest.get());
        aimedMm = Vectors.distance(session.entryNow(), aim);
    }

    /** Points the needle at where the target is now; it turns about its place in the skin. */
    public void aim() {
        asked.add(() -> {
            double[] aim = session.targetNow();
            session.redirect(aim);
            steps.redirected(timeS);
            aimedMm = Vectors.distance(session.entryNow(), aim);
        });
    }

    /** Takes a sample where the tip is. */
    public void sample() {
        asked.add(() -> {
            session.sample();
            steps.sampled(timeS);
        });
    }

    private NeedleState describe(int breath) {
        double[] at = session.targetNow();
        boolean placed = session.isPlaced();
        Optional<double[]> from = placed ? Optional.of(session.entryNow()) : entry.map(SkinPoint::now);
        double[] start = from.orElse(at);
        double aimed = placed ? Math.max(aimedMm, session.depthMm()) : Vectors.distance(start, at);
        double[] direction = placed
                ? session.directionNow()
                : aimed > 0 ? Vectors.unit(Vectors.minus(at, start)) : new double[] {0, 0, 1};
        double[] end = Vectors.add(start, direction, aimed);
        Optional<PathReading> path = from.map(skin -> reader.read(skin, end));
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
                Vectors.add(start, direction, depth - plan.needle().lengthMm()),
                Vectors.add(start, direction, depth),
                depth,
                aimed,
                session.isInLiver(),
                session.isMoving(),
                placed ? Optional.of(session.miss()) : Optional.empty(),
                path,
                path.map(p -> p.reasons(plan.avoided())).orElse(List.of()),
                margin,
                path.isPresent() ? scene.labelOf(reader.nearest()) : "",
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
