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
import org.phrenic.access.attempt.NeedleShaft;
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
 * A needle in a live run. It observes the run every {@link Rehearsal#FRAME_INTERVAL_S}, like a planned attempt.
 * Requests are executed in order at the next frame and recorded as steps of a plan. A manual attempt and the plan
 * recorded from it give bit-identical records, whether the plan is played live or headless. The attempt restarts with
 * the run.
 *
 * <p>Requests may be made from any thread and return immediately.
 */
public final class LiveRehearsal implements StepListener {
    /** Receives events, on the thread of the run. */
    public interface Listener {
        /** A request could not be executed. */
        void refused(String sentence);

        /** An attempt has ended: the needle was withdrawn after a sample, or the plan is complete. */
        void finished(LiveAttempt attempt);
    }

    /** Wall-clock time between two published states, ns. */
    private static final long SHOW_NS = 40_000_000;

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    private final LiveRun run;
    private final MovingAnatomy anatomy;
    private final Frame ofScene;
    private final RehearsalPlan plan;
    private final TargetLesion target;
    private final Optional<AccessMap> map;
    private final Listener listener;
    private final PathAnalyzer analyzer;
    private final Queue<Runnable> requests = new ConcurrentLinkedQueue<>();
    private final ManualStepRecorder steps = new ManualStepRecorder();

    private NeedleInsertion needle;
    private NeedleSnapshots snapshots;
    private PlanPlayer player;
    private Optional<double[]> entryRest = Optional.empty();
    private Optional<SkinPoint> entry = Optional.empty();
    private Optional<BreathEvent> holdAt = Optional.empty();
    private double aimedMm;
    private RespiratoryPhase before = RespiratoryPhase.PAUSE;
    private int breathBefore = 1;
    private Frame frame;
    private RespiratoryPhase phase = RespiratoryPhase.PAUSE;
    private double timeS;
    private boolean over;
    private long describedNs;
    private volatile NeedleState state;

    /**
     * @param run the run that the rehearsal is added to as a listener, every {@link Rehearsal#FRAME_INTERVAL_S}
     * @param anatomy anatomy of the surfaces of the run; used exclusively by the rehearsal
     * @param ofScene a frame of the scene of the run; frames of other scenes are ignored
     * @param map access map of the target for playing a plan; empty for a manual attempt
     */
    public LiveRehearsal(
            LiveRun run,
            MovingAnatomy anatomy,
            Frame ofScene,
            RehearsalPlan plan,
            TargetLesion target,
            Optional<AccessMap> map,
            Listener listener) {
        this.run = run;
        this.anatomy = anatomy;
        this.ofScene = ofScene;
        this.plan = plan;
        this.target = target;
        this.map = map;
        this.listener = listener;
        analyzer = new PathAnalyzer(anatomy, plan.needle());
    }

    /** While a needle by hand is in no body and nothing is asked of it, a frame changes nothing but what is shown. */
    @Override
    public boolean needsFrame() {
        return needle == null
                || player != null
                || needle.shaft().isPlaced()
                || !requests.isEmpty()
                || System.nanoTime() - describedNs > SHOW_NS;
    }

    @Override
    public void onStepWithoutFrame(double nowS, RespiratoryPhase doing, int breath) {
        if (nowS < timeS) {
            steps.clear();
            begin();
        }
        timeS = nowS;
        holdIfDue(doing, breath);
        before = doing;
        breathBefore = breath;
    }

    @Override
    public void onStep(Frame shownFrame, RespiratoryPhase doing) {
        if (!shownFrame.isOfSceneOf(ofScene)) {
            return;
        }
        frame = shownFrame;
        phase = doing;
        if (needle == null || frame.timeS() < timeS) {
            steps.clear();
            begin();
        }
        timeS = frame.timeS();
        int breath = 1 + (int) frame.values()[BREATH];
        needle.update(frame, phase);
        boolean done = player == null ? runRequests(breath) : play(breath);
        snapshots.observe(needle, frame, phase, player == null ? 0 : player.images());
        before = phase;
        breathBefore = breath;
        if (done) {
            List<PlanStep> taken = player == null ? steps.stepsUntil(timeS) : plan.steps();
            listener.finished(
                    new LiveAttempt(taken, target, needle.record(), snapshots.all(), timeS, run.commandHash()));
            over = true;
        }
        if (state == null || done || System.nanoTime() - describedNs > SHOW_NS) {
            describedNs = System.nanoTime();
            state = describe();
        }
    }

    private void begin() {
        needle = new NeedleInsertion(anatomy, target, plan.needle(), plan.avoided());
        snapshots = new NeedleSnapshots();
        player = map.isPresent() ? new PlanPlayer(plan, needle, map.get(), this::hold) : null;
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
            return player.update(phase, breath);
        } catch (BadInputException bad) {
            over = true;
            listener.refused(bad.getMessage());
            return false;
        }
    }

    /** Executes the pending requests. Returns whether the attempt has ended. */
    private boolean runRequests(int breath) {
        holdIfDue(phase, breath);
        for (Runnable next = requests.poll(); next != null; next = requests.poll()) {
            try {
                next.run();
            } catch (BadInputException bad) {
                listener.refused(bad.getMessage());
            }
        }
        return !over && !needle.shaft().isPlaced() && !needle.record().samples().isEmpty();
    }

    private void holdIfDue(RespiratoryPhase doing, int breath) {
        if (holdAt.isPresent() && holdAt.get().occurs(before, breathBefore, doing, breath)) {
            holdAt = Optional.empty();
            held(true);
        }
    }

    private void hold(boolean on, String origin) {
        run.change(List.of(Assignment.of(origin, Breathing.HOLD, on)));
    }

    private void held(boolean on) {
        hold(on, "window");
        steps.add(timeS, new PlanStep.HoldBreath("by hand, hold_breath", on));
    }

    /**
     * Requests a breath hold at the next event of a kind. A held breath is released first. An empty argument only
     * releases.
     */
    public void holdAt(Optional<BreathEvent.Kind> end) {
        requests.add(() -> {
            holdAt = end.map(kind -> new BreathEvent(kind, OptionalInt.empty()));
            if (run.scenario().hold()) {
                held(false);
            }
        });
    }

    /**
     * Chooses the entry point on the skin, given at end-expiration. The request fails while the needle is in the body.
     */
    public void enterAt(double[] onSkinAtRest) {
        requests.add(() -> {
            if (needle.shaft().isPlaced() && needle.shaft().depth() > 0) {
                throw new BadInputException("entry: found the needle in the body, expected it withdrawn first");
            }
            SkinPoint point = SkinPoint.atRest(anatomy.skin(), onSkinAtRest);
            entryRest = Optional.of(onSkinAtRest.clone());
            entry = Optional.of(point);
        });
    }

    /**
     * Moves the tip to a depth below the skin. If the needle is not placed, it is first placed on the skin and pointed
     * at the current position of the target.
     *
     * @param speedMmPerS positive speed, mm/s
     */
    public void moveTo(double depthMm, double speedMmPerS) {
        requests.add(() -> {
            if (!needle.shaft().isPlaced()) {
                place();
            }
            needle.advance(depthMm, speedMmPerS);
            steps.add(timeS, new PlanStep.Advance("by hand, advance", Optional.of(depthMm), speedMmPerS, false));
        });
    }

    private void place() {
        if (entryRest.isEmpty()) {
            throw new BadInputException("needle: found no entry, expected a place on the skin chosen first");
        }
        if (over) {
            // A new attempt starts in the same run.
            over = false;
            steps.keepBreathHolds();
            needle = new NeedleInsertion(anatomy, target, plan.needle(), plan.avoided());
            snapshots = new NeedleSnapshots();
            needle.update(frame, phase);
        }
        double[] aim = needle.targetNow();
        needle.placeAtRest(entryRest.get(), aim);
        steps.add(timeS, new PlanStep.Place("by hand, place", entryRest, false, PlanStep.Aim.TARGET));
        aimedMm = Vectors.distance(needle.shaft().entry(), aim);
    }

    /** Points the needle at the current position of the target by rotating it about its skin point. */
    public void aim() {
        requests.add(() -> {
            double[] aim = needle.targetNow();
            needle.redirect(aim);
            steps.add(timeS, new PlanStep.Redirect("by hand, redirect", PlanStep.Aim.TARGET));
            aimedMm = Vectors.distance(needle.shaft().entry(), aim);
        });
    }

    /** Takes a sample at the tip. */
    public void sample() {
        requests.add(() -> {
            needle.sample();
            steps.add(timeS, new PlanStep.Sample("by hand, sample"));
        });
    }

    private NeedleState describe() {
        NeedleShaft shaft = needle.shaft();
        double[] centre = needle.targetNow();
        boolean placed = shaft.isPlaced();
        Optional<double[]> from = placed ? Optional.of(shaft.entry()) : entry.map(SkinPoint::current);
        double[] start = from.orElse(centre);
        double aimed = placed ? Math.max(aimedMm, shaft.depth()) : Vectors.distance(start, centre);
        double[] direction = placed
                ? shaft.direction()
                : aimed > 0 ? Vectors.normalize(Vectors.subtract(centre, start)) : new double[] {0, 0, 1};
        double[] end = Vectors.addScaled(start, direction, aimed);
        Optional<PathAnalysis> path = from.map(skin -> analyzer.analyze(skin, end));
        PathAnalyzer.Margin margin =
                path.isPresent() ? analyzer.margin(start, end, plan.avoided()) : new PathAnalyzer.Margin(0, "");
        double depth = placed ? shaft.depth() : 0;
        return new NeedleState(
                timeS,
                phase,
                centre,
                target.radiusMm(),
                from,
                placed,
                Vectors.addScaled(start, direction, depth - plan.needle().lengthMm()),
                Vectors.addScaled(start, direction, depth),
                depth,
                aimed,
                shaft.isTipAnchored(),
                needle.isMoving(),
                placed ? Optional.of(needle.targetingError()) : Optional.empty(),
                path.map(p -> p.reasons(plan.avoided())).orElse(List.of()),
                margin.mm(),
                anatomy.labelOf(margin.nearest()),
                placed ? needle.warnings() : List.of(),
                needle.record().samples().size(),
                holdAt.map(BreathEvent::text).orElse(""));
    }

    /** The current state; null before the first frame. */
    public NeedleState state() {
        return state;
    }
}
