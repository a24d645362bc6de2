package org.phrenic.access.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.CycleRecorder;
import org.phrenic.access.FirstScene;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.attempt.AttemptEvent;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.access.plan.HeldProbe;
import org.phrenic.access.plan.ImageMoment;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PlanStep;
import org.phrenic.access.plan.ProbeHold;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalImage;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.anatomy.Thorax;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.YamlWriter;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.simulation.observe.Frame;

/**
 * Attempts on a run that is played on a thread of its own, as the window does it, against the same without a window:
 * the whole report, bit for bit.
 */
class LiveAttemptTest {
    private static final long PATIENCE_S = 60;
    /** A step takes several times as long. */
    private static final long POLL_NS = 100_000;

    private static final String BODY =
            "set: {preset: rapid-shallow, rate_per_min: 70, resolution: low, mesh_vertices: 3000, lungs: embedded,"
                    + " sternum: kinematic}\nphases: 3\n"
                    + "target: {rest_mm: [-90, 0, 50], diameter_mm: 20}\n";
    private static final double[] ENTRY = {-38.9, -121.2, 26.6};

    private static LiveRun run;
    private static LiveScene scene;
    private static Frame ofScene;
    private static MovingAnatomy mapped;
    private static TargetAccess study;

    @TempDir
    Path folder;

    private final Map<Double, ImageMoment> moments = new ConcurrentHashMap<>();

    private final CompletableFuture<Void> stopped = new CompletableFuture<>();
    /** Simulated time of the frame that the needle was given last, s. */
    private volatile double givenS;

    /** As the window does: one breath looked at, and the map computed. */
    @BeforeAll
    static void look(@TempDir Path folder) throws Exception {
        RehearsalPlan plan = plan(folder, "steps: []\n");
        CompletableFuture<LiveScene> loaded = new CompletableFuture<>();
        CompletableFuture<List<BreathMoment>> cycle = new CompletableFuture<>();
        run = new LiveRun(plan.scenario(), new FirstScene(loaded));
        run.showOrgans();
        run.setSpeed(Double.POSITIVE_INFINITY);
        run.play();
        scene = loaded.get(PATIENCE_S, TimeUnit.SECONDS);
        ofScene = scene.newFrame().get();
        CycleRecorder recorder = new CycleRecorder(run, ofScene, plan.moments(), share -> {}, cycle::complete);
        run.restart(recorder, recorder);
        mapped = new MovingAnatomy(scene.surfaces());
        List<BreathMoment> moments = cycle.get(PATIENCE_S, TimeUnit.SECONDS);
        run.pause();
        try (Workers workers = Workers.of(2)) {
            study = TargetAccess.of(mapped, moments, plan.target(mapped), plan.needle(), plan.avoided(), workers);
        }
    }

    @AfterAll
    static void end() {
        run.close();
    }

    private RehearsalPlan plan(String steps) throws IOException {
        return plan(folder, steps);
    }

    private static RehearsalPlan plan(Path folder, String steps) throws IOException {
        return RehearsalPlan.read(Files.writeString(folder.resolve("plan.yaml"), BODY + steps));
    }

    @Test
    void aPlanPlayedLiveGivesTheReportOfTheSamePlanHeadless() throws Exception {
        RehearsalPlan plan = plan("steps:\n  - wait: end-inspiration of breath 1\n  - hold_breath: true\n"
                + "  - place: {entry: [-38.9, -121.2, 26.6], aim: target}\n"
                + "  - advance: {speed_mm_per_s: 120}\n  - sample: now\n  - withdraw: {speed_mm_per_s: 300}\n"
                + "  - hold_breath: false\n  - wait: 0.1\n");
        Rehearsal live = live(plan, true, needle -> {});
        assertThat(live.record().events()).isNotEmpty();
        assertThat(report(live)).contains("not_in_scan");
        assertThat(report(live)).isEqualTo(report(Rehearsal.play(plan, scanned(), (at, total, perS) -> {})));
    }

    @Test
    void whatWasDoneByHandIsAPlanThatGivesTheSameReportHeadless() throws Exception {
        RehearsalPlan practice = plan("steps: []\n");
        Rehearsal live = live(practice, false, needle -> {
            // In again and again before it is there, aimed again, the breath held in between: all that a hand may do.
            when(needle, s -> s.timeS() > 0.1);
            stepOnce();
            run.play();
            needle.holdProbe(Optional.of(probe(0, 0)));
            needle.enterAt(ENTRY, new NeedleAngles(-20, 15));
            needle.turnTo(new NeedleAngles(-30, 18));
            when(needle, s -> s.probe().isPresent() && s.angles().axialDeg() < -29);
            stepOnce();
            run.play();
            needle.moveTo(20, 90);
            when(needle, s -> s.depthMm() > 4);
            stepOnce();
            run.play();
            needle.moveTo(12, 45);
            needle.holdAt(Optional.of(BreathEvent.Kind.END_INSPIRATION));
            assertThat(needle.heldAt()).as("asked for").contains(BreathEvent.Kind.END_INSPIRATION);
            when(needle, s -> !s.moving() && s.label() == RespiratoryPhase.HOLD);
            assertThat(needle.heldAt()).as("in effect").contains(BreathEvent.Kind.END_INSPIRATION);
            needle.aim();
            needle.moveTo(70, 150);
            when(needle, s -> s.inLiver() && !s.moving());
            needle.holdProbe(Optional.of(probe(40, 12)));
            needle.sample();
            when(needle, s -> s.samples() == 1);
            needle.holdAt(Optional.empty());
            assertThat(needle.heldAt()).isEmpty();
            needle.moveTo(0, 300);
        });
        assertThat(live.record().count(AttemptEvent.Kind.REDIRECTION)).isEqualTo(1);
        assertThat(live.plan().steps())
                .anyMatch(PlanStep.HoldBreath.class::isInstance)
                .filteredOn(PlanStep.Probe.class::isInstance)
                .hasSize(2);
        assertThat(live.plan().aimsByProgram()).as("aimed again").isEqualTo(1);
        assertThat(live.probe().probeS())
                .isGreaterThan(live.record().insideS())
                .isLessThanOrEqualTo(live.record().timeS() + 1);
        YamlWriter.write(folder.resolve("scenario.yaml"), live.plan().scenario().toMap());
        YamlWriter.write(folder.resolve("by-hand.yaml"), live.plan().toMap("scenario.yaml"));
        RehearsalPlan again = RehearsalPlan.read(folder.resolve("by-hand.yaml"));
        Rehearsal headless = Rehearsal.play(again, scanned(), (at, total, perS) -> {});
        assertThat(report(headless)).isEqualTo(report(live));
        assertThat(imageAtSample(headless))
                .as("the image of the sample's moment, without and with a live run")
                .isEqualTo(liveImage(live, sample(live)));
    }

    @Test
    void aPlanWithAStepThatCannotBeExecutedIsToldAndEndsThere() throws Exception {
        RehearsalPlan plan = plan("steps: [{wait: 0.1}, {advance: {depth_mm: 20}}]\n");
        assertThatThrownBy(() -> live(plan, true, needle -> {})).hasMessageContaining("step 2, advance");
        stopped.get(PATIENCE_S, TimeUnit.SECONDS);
    }

    /**
     * Keys come faster than the state is published: what was asked for before is what the next request goes on from.
     */
    @Test
    void aRequestGoesOnFromTheRequestsBeforeItAndNotFromWhatIsShown() throws Exception {
        Rehearsal live = live(plan("steps: []\n"), false, needle -> {
            needle.enterAt(ENTRY, new NeedleAngles(90, 0));
            when(needle, s -> s.hasNeedle() && s.angles().axialDeg() > 89);
            needle.moveTo(0, 90);
            needle.enterAt(ENTRY, new NeedleAngles(-31, 16));
            needle.turnBy(1, 0);
            needle.turnBy(0, 2);
            needle.moveToTarget(150);
            needle.moveBy(2, 150);
            when(needle, s -> s.placed() && s.depthMm() > 1 && !s.moving());
            needle.sample();
            needle.moveTo(0, 300);
        });
        List<PlanStep> done = live.plan().steps().stream()
                .filter(step -> !(step instanceof PlanStep.WaitSeconds))
                .toList();
        assertThat(done)
                .extracting(step -> step.getClass().getSimpleName())
                .as("a needle that is out stays out at a depth of 0")
                .containsExactly("Place", "Advance", "Advance", "Sample", "Advance");
        NeedleAngles placed = ((PlanStep.Place) done.get(0)).aim().angles().orElseThrow();
        assertThat(placed.axialDeg()).isCloseTo(-30, within(1e-9));
        assertThat(placed.cranialDeg()).isCloseTo(18, within(1e-9));
        double targetMm = ((PlanStep.Advance) done.get(1)).depthMm().orElseThrow();
        assertThat(targetMm)
                .as("where this line passes nearest to the target; the former line leads away from it")
                .isGreaterThan(40);
        assertThat(((PlanStep.Advance) done.get(2)).depthMm()).contains(targetMm + 2);
    }

    /** Time of the paused run, s; everything that was asked of it before is done. */
    private static double pausedAtS() {
        return run.recordedScenario().steps() * run.status().dtS();
    }

    /** As the key for one step does it; the time that is reached, s. */
    private static double stepOnce() {
        run.pause();
        run.stepOnce();
        return pausedAtS();
    }

    /** A breath in and out, with the probe on the skin, may be gone through by single steps alone. */
    @Test
    void targetAndProbeOfAPausedRunAreThoseOfItsBodyAtEachStep() throws Exception {
        live(plan("steps: []\n"), false, needle -> {
            needle.holdProbe(Optional.of(probe(0, 0)));
            needle.enterAt(ENTRY, new NeedleAngles(-30, 18));
            when(needle, s -> s.probe().isPresent() && s.hasNeedle());
            run.pause();
            double pausedS = pausedAtS();
            MovingAnatomy body = new MovingAnatomy(scene.surfaces());
            for (int step = 0; step < 12; step++) {
                NeedleState shown = needle.state();
                assertThat(shown.timeS()).isCloseTo(pausedS, within(1e-9));
                Frame picture = scene.newFrame().get();
                assertThat(run.copyNewestFrame(picture)).isTrue();
                assertThat(picture.timeS()).isEqualTo(shown.timeS());
                body.update(picture);
                NeedleInsertion out = new NeedleInsertion(body, study.target(), Needle.standard(), Set.of());
                assertThat(shown.target()).isEqualTo(out.targetNow());
                HeldProbe held = new HeldProbe(body);
                held.update(picture, out);
                held.hold(Optional.of(probe(0, 0)));
                assertThat(shown.probe().orElseThrow().pose())
                        .usingRecursiveComparison()
                        .isEqualTo(held.pose().orElseThrow());
                pausedS = stepOnce();
            }
            run.play();
            sampleAndTakeOut(needle);
        });
    }

    /** Sections and images are made of the states that the clock asks for, which go on from step to step. */
    @Test
    void imagesGoOnWithSingleSteps() throws Exception {
        live(plan("steps: []\n"), false, needle -> {
            needle.holdProbe(Optional.of(probe(0, 0)));
            when(needle, s -> s.probe().isPresent());
            double fromS = stepOnce();
            double nowS = fromS;
            while (nowS < fromS + 2 * Rehearsal.FRAME_INTERVAL_S
                    && moments.keySet().stream().noneMatch(timeS -> timeS > fromS)) {
                // Longer than a state is left undescribed.
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(150));
                nowS = stepOnce();
            }
            assertThat(moments.keySet()).anyMatch(timeS -> timeS > fromS);
            run.play();
            needle.enterAt(ENTRY, new NeedleAngles(-30, 18));
            sampleAndTakeOut(needle);
        });
    }

    private static void sampleAndTakeOut(LiveRehearsal needle) {
        needle.moveTo(20, 90);
        when(needle, s -> s.depthMm() > 1);
        needle.sample();
        needle.moveTo(0, 300);
    }

    /** Frames come faster than states are described; of a run that stands still the newest of them counts. */
    @Test
    void aNeedleThatMovesIsShownAtEachSingleStep() throws Exception {
        run.reset();
        List<Frame> frames = new ArrayList<>();
        for (int step = 0; step < 8; step++) {
            Frame frame = scene.newFrame().get();
            stepOnce();
            assertThat(run.copyNewestFrame(frame)).isTrue();
            frames.add(frame);
        }
        LiveRehearsal needle = new LiveRehearsal(
                run,
                new MovingAnatomy(scene.surfaces()),
                ofScene,
                plan("steps: []\n"),
                study.target(),
                Optional.empty(),
                new Ended(new CompletableFuture<>(), new CompletableFuture<>(), stopped));
        needle.onStep(frames.get(0), RespiratoryPhase.INSPIRATION);
        needle.enterAt(ENTRY, new NeedleAngles(-30, 18));
        needle.moveTo(20, 50);
        for (int step = 1; step < 7; step++) {
            needle.onStep(frames.get(step), RespiratoryPhase.INSPIRATION);
            needle.onPause(frames.get(7), RespiratoryPhase.INSPIRATION);
            assertThat(needle.state().placed()).isTrue();
            assertThat(needle.state().timeS()).isEqualTo(frames.get(step).timeS());
        }
    }

    /** What is shown of a paused run, and is saved as a picture, is one moment. */
    @Test
    void thePausedRunShowsTheNeedleAsItIsThen() throws Exception {
        live(plan("steps: []\n"), false, needle -> {
            needle.enterAt(ENTRY, new NeedleAngles(-30, 18));
            needle.moveTo(20, 20);
            for (int time = 0; time < 5; time++) {
                double depthMm = 2 + 2 * time;
                when(needle, s -> s.depthMm() > depthMm);
                run.pause();
                double nowS = pausedAtS();
                for (int step = 0; step < 4; step++) {
                    assertThat(needle.state().timeS())
                            .isBetween(nowS - Rehearsal.FRAME_INTERVAL_S, nowS + 1e-9)
                            .isEqualTo(givenS);
                    nowS = stepOnce();
                }
                run.play();
            }
            needle.sample();
            needle.moveTo(0, 300);
        });
    }

    private static NeedleSnapshot sample(Rehearsal rehearsal) {
        return rehearsal.snapshots().stream()
                .filter(s -> s.name().equals("sample"))
                .findFirst()
                .orElseThrow();
    }

    /** Grey levels of the image that the window shows of a moment. */
    private byte[] liveImage(Rehearsal live, NeedleSnapshot at) {
        Ultrasound ultrasound =
                new Ultrasound(live.surfaces(), CurvilinearProbe.abdominal(), 1, Optional.of(live.target()));
        return moments.get(at.frame().timeS()).take(ultrasound, at.frame()).grey();
    }

    /** Grey levels of the image that a plan's report has of the sample, with the probe as its steps hold it. */
    private static byte[] imageAtSample(Rehearsal played) {
        List<ProbeHold> holds = played.plan().steps().stream()
                .filter(PlanStep.Probe.class::isInstance)
                .flatMap(step -> ((PlanStep.Probe) step).hold().stream())
                .toList();
        List<PlanStep> imaging = List.of(new PlanStep.Image("sample", holds.get(holds.size() - 1)));
        NeedleSnapshot at = sample(played);
        NeedleSnapshot asked = new NeedleSnapshot(
                "ultrasound_1", at.frame(), at.label(), true, at.hub(), at.tip(), at.target(), at.targetRadiusMm());
        Rehearsal withImage = new Rehearsal(
                played.plan().withSteps(played.target(), imaging, 1),
                played.body(),
                played.targetAccess(),
                played.path(),
                played.record(),
                played.probe(),
                List.of(asked),
                played.stateHash());
        return RehearsalImage.of(withImage).get(0).image().grey();
    }

    private static ProbeHold probe(double rotationDeg, double tiltDeg) {
        return ProbeHold.at(ENTRY, new ProbePose.Angles(rotationDeg, tiltDeg, 0), UltrasoundSettings.DEFAULT);
    }

    /** The body as of a scan that does not show its skin. */
    private static Thorax scanned() {
        Thorax body = scene.body();
        return new Thorax(body.name(), body.structures(), body.notes(), Set.of("skin"), body.organs());
    }

    private static String report(Rehearsal rehearsal) {
        return JsonWriter.format(new RehearsalReport(rehearsal).values());
    }

    private static void when(LiveRehearsal needle, java.util.function.Predicate<NeedleState> holds) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
        while (needle.state() == null || !holds.test(needle.state())) {
            assertThat(System.nanoTime()).as(() -> "waiting; " + needle.state()).isLessThan(end);
            LockSupport.parkNanos(POLL_NS);
        }
    }

    /** As the window does: the run that was looked at is at its start again, and then played by plan or by hand. */
    private Rehearsal live(RehearsalPlan plan, boolean played, Consumer<LiveRehearsal> hand) throws Exception {
        CompletableFuture<LiveAttempt> ended = new CompletableFuture<>();
        CompletableFuture<LiveRehearsal> itself = new CompletableFuture<>();
        LiveRehearsal needle = new LiveRehearsal(
                run,
                new MovingAnatomy(scene.surfaces()),
                ofScene,
                plan,
                study.target(),
                played ? Optional.of(study.map()) : Optional.empty(),
                new Ended(itself, ended, stopped));
        itself.complete(needle);
        StepListener watching = needle.andThen((frame, label) -> {
            givenS = frame.timeS();
            needle.imageMoment().ifPresent(moment -> moments.put(frame.timeS(), moment));
        });
        run.restart(StepListener.Trigger.every(Rehearsal.FRAME_INTERVAL_S), watching);
        run.play();
        try {
            hand.accept(needle);
            LiveAttempt attempt = ended.get(PATIENCE_S, TimeUnit.SECONDS);
            RehearsalPlan done = played ? plan : attempt.toPlan(plan);
            return attempt.toRehearsal(done, new BodySurfaces(scene.surfaces(), scanned()), study, mapped);
        } finally {
            run.pause();
        }
    }

    private record Ended(
            CompletableFuture<LiveRehearsal> needle,
            CompletableFuture<LiveAttempt> attempt,
            CompletableFuture<Void> stop)
            implements AttemptListener {
        @Override
        public void refused(String sentence) {
            attempt.completeExceptionally(new IllegalStateException(sentence));
        }

        @Override
        public void finished(LiveAttempt done) {
            if (needle.join().state().placed()) {
                refused("told of an end while the needle is shown in the body");
            }
            attempt.complete(done);
        }

        @Override
        public void stopped() {
            stop.complete(null);
        }
    }
}
