package org.phrenic.access.live;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshots;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.access.plan.HeldProbe;
import org.phrenic.access.plan.ImageMoment;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PlanPlayer;
import org.phrenic.access.plan.PlanStep;
import org.phrenic.access.plan.ProbeHold;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.breathing.RespiratoryPhase;
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
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    private final LiveRun run;
    private final MovingAnatomy anatomy;
    private final Frame ofScene;
    private final RehearsalPlan plan;
    private final TargetLesion target;
    private final Optional<AccessMap> map;
    private final AttemptListener listener;
    private final NeedleObserver observer;
    private final HeldProbe probe;
    private final HandOnProbe hand;
    private final AskedMoves moves = new AskedMoves();
    private final RequestQueue requests = new RequestQueue();
    private final ManualStepRecorder steps = new ManualStepRecorder();
    private final HandOnNeedle grip;
    private final BreathCommands breathing;
    private NeedleInsertion needle;
    private NeedleSnapshots snapshots;
    private PlayedPlan player;
    private boolean fresh;
    private Frame frame;
    private RespiratoryPhase phase = RespiratoryPhase.PAUSE;
    /** Time of the last frame, s. */
    private double timeS;
    /** Held while a step is taken note of and while requests are executed, which two threads may do. */
    private final Object stepLock = new Object();

    private final StepOrder order = new StepOrder();
    private boolean over;
    private final ShownNeedle shown;

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
            AttemptListener listener) {
        this.run = run;
        this.anatomy = anatomy;
        this.ofScene = ofScene;
        this.plan = plan;
        this.target = target;
        this.map = map;
        this.listener = listener;
        observer = new NeedleObserver(anatomy, plan);
        probe = new HeldProbe(anatomy);
        hand = new HandOnProbe(probe, steps);
        grip = new HandOnNeedle(anatomy, steps);
        shown = new ShownNeedle(observer, probe, grip, moves);
        breathing = new BreathCommands(run, steps, plan.reactionS());
    }

    /** While a needle by hand is in no body and nothing is asked of it, a frame changes nothing but what is shown. */
    @Override
    public boolean needsFrame() {
        return isNeedleInUse() || shown.isOld();
    }

    private boolean isNeedleInUse() {
        return needle == null || player != null || needle.shaft().isPlaced() || !requests.isEmpty() || hand.isAsked();
    }

    /** A needle by hand changes only breath holds, which need no frame; its end needs the state of the step. */
    @Override
    public boolean maySeeFrameLater() {
        return needle != null
                && player == null
                && (over || needle.record().samples().isEmpty());
    }

    @Override
    public void onStepWithoutFrame(double nowS, RespiratoryPhase doing, int breath) {
        synchronized (stepLock) {
            takeNote(nowS, doing, breath);
            order.comesLater(nowS);
        }
    }

    /** Requests that come after this are executed at a later step, whose frame is then needed. */
    @Override
    public boolean passes(double nowS, RespiratoryPhase doing, int breath) {
        synchronized (stepLock) {
            // The state is published from the frame at work, however late that is.
            if (isNeedleInUse() || !maySeeFrameLater()) {
                return false;
            }
            takeNote(nowS, doing, breath);
            return true;
        }
    }

    private void takeNote(double nowS, RespiratoryPhase doing, int breath) {
        if (order.step(nowS)) {
            begin();
        }
        breathing.update(doing, breath, nowS);
    }

    @Override
    public void onStep(Frame shownFrame, RespiratoryPhase doing) {
        if (!shownFrame.isOfSceneOf(ofScene)) {
            return;
        }
        frame = shownFrame;
        phase = doing;
        timeS = frame.timeS();
        synchronized (stepLock) {
            if (order.frame(timeS) || needle == null) {
                begin();
            }
        }
        needle.update(frame, phase);
        probe.update(frame, needle);
        boolean done;
        synchronized (stepLock) {
            // After steps that have passed, requests wait for the frame of a step of their own.
            done = order.isLast(timeS) && act(1 + (int) frame.values()[BREATH]);
        }
        snapshots.observe(needle, frame, phase);
        if (done || shown.isDue()) {
            shown.describe(needle, frame, phase);
        }
        if (done) {
            // Who is told of the end finds the needle out.
            finish();
        }
    }

    /** Shows the needle as it is when the run stands still, however short a time ago it was shown. */
    @Override
    public void onPause(Frame present, RespiratoryPhase doing) {
        if (needle == null || !present.isOfSceneOf(ofScene)) {
            return;
        }
        if (needle.shaft().isPlaced()) {
            // What it does is recorded at the frames of its steps alone.
            shown.describeAtPause(needle, frame, phase);
        } else {
            anatomy.update(present);
            probe.update(present, needle);
            shown.describeAtPause(needle, present, doing);
        }
    }

    /** Executes what is asked for or planned at this step; returns whether the attempt has ended. */
    private boolean act(int breath) {
        if (fresh) {
            fresh = false;
            hand.begin(timeS);
        }
        return player == null ? runRequests(breath) : play(breath);
    }

    private void finish() {
        List<PlanStep> taken = player == null ? steps.stepsUntil(timeS) : plan.steps();
        listener.finished(new LiveAttempt(
                taken, target, needle.record(), probe.use(), snapshots.all(), timeS, run.commandHash()));
        over = true;
        if (player == null) {
            // The next attempt in this run.
            steps.keepBreathHolds();
            hand.begin(timeS);
        }
    }

    private void begin() {
        steps.clear();
        needle = new NeedleInsertion(anatomy, target, plan.needle(), plan.avoided());
        snapshots = new NeedleSnapshots();
        player = map.map(on -> new PlanPlayer(plan, needle, snapshots, probe, on, breathing::hold))
                .map(played -> new PlayedPlan(played, listener))
                .orElse(null);
        breathing.begin();
        over = false;
        fresh = true;
    }

    private boolean play(int breath) {
        requests.clear();
        return !over && player.update(frame, phase, breath);
    }

    /** Executes the pending requests. Returns whether the attempt has ended. */
    private boolean runRequests(int breath) {
        breathing.update(phase, breath, timeS);
        requests.add(() -> hand.move(timeS));
        requests.runAll(() -> snapshots.observe(needle, frame, phase), listener::refused);
        return !over && !needle.shaft().isPlaced() && !needle.record().samples().isEmpty();
    }

    /** Requests a breath hold at the next event of a kind, after the release of a held breath; empty only releases. */
    public void holdAt(Optional<BreathEvent.Kind> end) {
        breathing.ask(end);
    }

    /** The end of a phase at which the breath is held by hand, or will be; empty if it goes on. On any thread. */
    public Optional<BreathEvent.Kind> heldAt() {
        return breathing.heldAt();
    }

    /** Whether the breath is held, or will be, once all that was asked for is done. On any thread. */
    public boolean isBreathHeld() {
        return breathing.isHeld();
    }

    /**
     * Chooses the entry point on the skin, given at end-expiration. The request fails while the needle is on the skin
     * or in the body.
     *
     * @param initialAngles angles of the needle there until it is turned or aimed
     */
    public void enterAt(double[] onSkinAtRest, NeedleAngles initialAngles) {
        requests.add(() -> grip.enter(needle, onSkinAtRest, initialAngles));
    }

    /**
     * Moves the tip to a depth below the skin. If the needle is not placed, it is first placed on the skin, with its
     * angles or, if it was aimed, pointed at the current position of the target; at a depth of 0 it stays out.
     *
     * @param speedMmPerS positive speed, mm/s
     */
    public void moveTo(double depthMm, double speedMmPerS) {
        requests.add(moves.counted(() -> advance(depthMm, speedMmPerS)));
    }

    /** As {@link #moveTo}, by so many mm: {@link NeedleInsertion#depthAfter} all earlier requests. */
    public void moveBy(double mm, double speedMmPerS) {
        requests.add(moves.counted(() -> advance(needle.depthAfter(mm), speedMmPerS)));
    }

    private void advance(double depthMm, double speedMmPerS) {
        if (needle.shaft().isPlaced() || depthMm > 0) {
            place();
            grip.advance(needle, depthMm, speedMmPerS, timeS);
        }
    }

    /** As {@link #moveTo}, to where the needle passes nearest to the target when the request is executed. */
    public void moveToTarget(double speedMmPerS) {
        requests.add(moves.counted(() -> {
            place();
            grip.advance(needle, needle.targetDepthMm(), speedMmPerS, timeS);
        }));
    }

    /** Places a needle that is not placed. */
    private void place() {
        if (needle.shaft().isPlaced()) {
            return;
        }
        grip.requireEntry();
        if (over) {
            // A new attempt starts in the same run.
            over = false;
            needle = new NeedleInsertion(anatomy, target, plan.needle(), plan.avoided());
            snapshots = new NeedleSnapshots();
            needle.update(frame, phase);
        }
        grip.place(needle, timeS);
    }

    /** Points the needle at the current position of the target by rotating it about its skin point. */
    public void aim() {
        requests.add(() -> grip.aim(needle, timeS));
    }

    /**
     * Turns the needle about its point on the skin; the last of several turns within a frame counts, if nothing else is
     * requested between them.
     */
    public void turnTo(NeedleAngles to) {
        requests.addTurn(() -> grip.turn(needle, to, timeS));
    }

    /** Turns the needle from the angles that it has once all earlier requests are executed, degrees. */
    public void turnBy(double axialDeg, double cranialDeg) {
        requests.add(() -> grip.turnBy(needle, axialDeg, cranialDeg, timeS));
    }

    /** Puts the probe on the skin, moves it, or lifts it; the last of several moves within a frame counts. */
    public void holdProbe(Optional<ProbeHold> as) {
        hand.ask(as);
    }

    /** What an ultrasound image of the current frame is made of, on the thread of {@link #onStep}; empty if none. */
    public Optional<ImageMoment> imageMoment() {
        return needle == null || frame == null ? Optional.empty() : probe.moment(needle);
    }

    /** Takes a sample at the tip. */
    public void sample() {
        requests.add(() -> {
            needle.sample();
            steps.add(timeS, new PlanStep.Sample("by hand, sample"));
        });
    }

    /** Whether all moves asked for are in a {@link #state()} that is asked for after this. */
    public boolean showsMoves() {
        return moves.areShown();
    }

    /** The current state; null before the first frame. */
    public NeedleState state() {
        return shown.state();
    }
}
