package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;
import org.phrenic.model.material.RigidTendon;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

/** A run on a thread of its own, as a window drives it. */
class LiveRunTest extends LiveRunHarness {
    /** Lungs with which what was recorded is repeated by a live run; with others by a simulation without a window. */
    private static final String LIVE_AGAIN = "lungs=embedded";
    /** What no body bears: the lightest sheet under the greatest pressure, undamped. */
    private static final String[] UNBEARABLE = {
        "area_density_kg_per_m2=3", "greatest_pressure_kpa=20", "damping_rate_per_s=0", "muscle_stiffness_n_per_m=30"
    };

    @TempDir
    Path folder;

    private static double value(Frame frame, String column) {
        return frame.values()[Observation.COLUMNS.indexOf(column)];
    }

    @Test
    void itLoadsPlaysPausesStepsAndGoesBackToTheStart() throws InterruptedException {
        start();
        LiveScene scene = next(scenes);
        assertThat(stages).containsExactly("body", "scene", "surfaces", "done");
        LiveScene body = bodies.remove();
        assertThat(body.isAtRest()).isTrue();
        assertThat(scene.isAtRest()).isFalse();
        assertThat(body.surfaces().stream().map(Surface::name))
                .containsExactlyInAnyOrderElementsOf(
                        scene.surfaces().stream().map(Surface::name).toList());
        Frame frame = scene.newFrame().get();
        assertThat(run.isPlaying()).isFalse();
        String atStart = run.commandHash();
        run.setSpeed(Double.POSITIVE_INFINITY);
        run.play();
        steps(600);
        until(() -> run.copyNewestFrame(frame) && frame.step() >= 600);
        assertThat(value(frame, "dome_right_mm")).as("breathes in").isLessThan(-0.5);
        assertThat(frame.isFinite()).isTrue();
        until(() -> run.status().stepsPerS() > 0);
        run.pause();
        until(() -> !run.status().playing());
        long there = run.status().step();
        run.stepOnce();
        until(() -> run.status().step() == there + 1);
        RunHistory history = run.history();
        assertThat(history.size()).isGreaterThan(20);
        assertThat(history.time(1) - history.time(0)).isCloseTo(0.02, org.assertj.core.api.Assertions.within(1e-9));
        assertThat(history.values(3)).hasSize(Observation.COLUMNS.size());
        assertThat(history.latest()).hasValue(history.values(history.size() - 1));
        Frame past = scene.newFrame().get();
        assertThat(history.frame(0, past)).isTrue();
        assertThat(past.timeS())
                .isEqualTo(history.frameTime(0))
                .isLessThan(run.status().timeS());
        run.reset();
        until(() -> run.status().step() == 0);
        assertThat(run.commandHash()).isEqualTo(atStart);
        assertThat(run.history().size()).isEqualTo(1);
        run.history().truncateAfter(-1);
        assertThat(run.history().latest()).isEmpty();
        until(() -> run.copyNewestFrame(frame) && frame.step() == 0);
    }

    @Test
    void changesActAtOnceAndARefusedOneLeavesTheSettingsAsTheyWere() throws InterruptedException {
        start();
        next(scenes);
        change("depth=2", "preset=deep");
        assertThat(run.scenario().preset()).isEqualTo("deep");
        run.setSpeed(Double.POSITIVE_INFINITY);
        run.play();
        steps(50);
        change("inspiratory_fraction=0.8", "preset=sniff");
        assertThat(next(failures)).contains("inspiratory fraction").doesNotContain("\n");
        until(() -> run.scenario().preset().equals("deep"));
        assertThat(run.status().step()).isPositive();
        assertThatExceptionOfType(BadInputException.class).isThrownBy(() -> change("depth=9"));
        assertThat(run.recordedScenario().changes()).hasSize(2);
        change("muscle_stiffness_n_per_m=3000");
        until(() -> !run.status().stabilityMessage().isEmpty());
        assertThat(run.status().stabilityMessage()).contains("beyond the stability limit");
        assertThat(run.status().substeps()).isGreaterThan(1);
        assertThat(run.recordedScenario().changes())
                .as("of both moments")
                .extracting(change -> change.assignment().key())
                .containsExactly("depth", "preset", "muscle_stiffness_n_per_m");
    }

    @Test
    void aStructuralChangeLoadsBesideTheRunningSceneAndCanBeCalledOff() throws InterruptedException {
        start();
        LiveScene first = next(scenes);
        run.setSpeed(Double.POSITIVE_INFINITY);
        run.play();
        change("links_per_node=2");
        assertThat(run.scenario().get(RigidTendon.LINKS_PER_NODE)).isEqualTo(2);
        run.cancelLoading();
        until(() -> run.scenario().get(RigidTendon.LINKS_PER_NODE) == 1);
        steps(20);
        change("links_per_node=3");
        change("depth=1.5");
        long before = run.status().step();
        LiveScene second = next(scenes);
        assertThat(second.id()).isGreaterThan(first.id());
        assertThat(second.scenario().get(RigidTendon.LINKS_PER_NODE)).isEqualTo(3);
        assertThat(before).as("went on meanwhile").isPositive();
        assertThat(run.scenario().toMap()).containsEntry("depth", 1.5);
        until(() -> {
            Scenario recorded = run.recordedScenario();
            List<Assignment> changes =
                    recorded.changes().stream().map(ScheduledChange::assignment).toList();
            return recorded.with(changes).toMap().get("depth").equals(1.5);
        });
        assertThat(run.copyNewestFrame(first.newFrame().get()))
                .as("a frame of the old scene")
                .isFalse();
    }

    /** The window offers what the scene that loads uses. */
    @Test
    void aChangeThatOnlyTheComingSceneTakesWaitsForIt() throws InterruptedException {
        start();
        next(scenes);
        run.play();
        change("material=paper");
        change("muscle_force_mn=3");
        steps(5);
        assertThat(next(scenes).scenario().material().label()).isEqualTo("paper");
        assertThat(run.scenario().toMap()).containsEntry("muscle_force_mn", 3.0);
        until(() -> !run.recordedScenario().changes().isEmpty());
        assertThat(failures).isEmpty();
    }

    @Test
    void aChangeForASceneThatCannotBeLoadedIsForgottenAndTheReasonToldOnce() throws InterruptedException {
        start();
        next(scenes);
        run.play();
        change("material=paper", "anatomy=" + folder);
        change("muscle_force_mn=3");
        assertThat(next(failures)).contains(folder.toString());
        until(() -> run.scenario().material().label().equals("physical"));
        steps(5);
        assertThat(run.isPlaying()).isTrue();
        assertThat(failures).isEmpty();
    }

    /** Organs that were called off are not taken to be there. */
    @Test
    void organsAreLoadedAgainAfterACancelledLoad() throws InterruptedException {
        start();
        next(scenes);
        assertThat(run.showOrgans()).isTrue();
        run.cancelLoading();
        until(() -> !run.isLoading());
        assertThat(run.hasOrgans()).isFalse();
        assertThat(run.showOrgans()).isTrue();
        assertThat(next(scenes).surfaces()).anyMatch(s -> s.kind() == StructureKind.ORGAN);
        until(run::hasOrgans);
        assertThat(run.showOrgans()).isFalse();
    }

    /** A listener that waits, at its first frame, for three later steps, which pass. */
    @Test
    void stepsThatPassDoNotWaitForTheFrameOfAnEarlierOne() throws InterruptedException {
        CountDownLatch passed = new CountDownLatch(3);
        BlockingQueue<Boolean> wereWaitedFor = new LinkedBlockingQueue<>();
        StepListener watch = new StepListener() {
            @Override
            public void onStep(Frame frame, RespiratoryPhase label) {
                try {
                    wereWaitedFor.add(passed.await(PATIENCE_S, TimeUnit.SECONDS));
                } catch (InterruptedException stop) {
                    wereWaitedFor.add(false);
                }
            }

            @Override
            public boolean needsFrame() {
                return passed.getCount() == 3;
            }

            @Override
            public boolean maySeeFrameLater() {
                return true;
            }

            @Override
            public boolean passes(double timeS, RespiratoryPhase label, int breath) {
                passed.countDown();
                return true;
            }
        };
        start();
        next(scenes);
        run.play();
        steps(1);
        run.restart(StepListener.Trigger.every(0.02), watch);
        assertThat(next(wereWaitedFor)).isTrue();
    }

    /** The task of one frame fails beside the run: the run stops, each time with a word, and still answers. */
    @Test
    void aFrameThatFailsStopsTheRunAndItsReasonIsReportedOnce() throws InterruptedException {
        StepListener watch = new StepListener() {
            @Override
            public void onStep(Frame frame, RespiratoryPhase label) {
                throw new IllegalStateException("no frame of this kind");
            }

            @Override
            public boolean maySeeFrameLater() {
                return true;
            }
        };
        start();
        next(scenes);
        // The next frame to show comes before the next one to keep.
        run.setSpeed(0.1);
        run.play();
        steps(1);
        run.restart(StepListener.Trigger.every(100), watch);
        assertThat(next(failures)).isEqualTo("no frame of this kind");
        until(() -> !run.status().playing());
        assertThat(run.commandHash()).hasSize(64);
        assertThat(failures).isEmpty();
        run.play();
        steps(1);
        run.restart(StepListener.Trigger.every(100), watch);
        until(() -> !run.isPlaying());
        until(() -> !playingShown);
        assertThat(failures).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {LIVE_AGAIN, "lungs=springs"})
    void aRunThatLeavesAllBoundsStopsShowsNothingBrokenAndGoesOnWithoutItsLastChange(String lungs)
            throws InterruptedException {
        start("preset=cough", lungs);
        LiveScene scene = next(scenes);
        run.setSpeed(Double.POSITIVE_INFINITY);
        run.play();
        steps(100);
        change(UNBEARABLE);
        String sentence = next(divergences);
        assertThat(sentence).contains("diverged").contains("the last change was muscle_stiffness_n_per_m");
        assertThat(run.isPlaying()).isFalse();
        Frame frame = scene.newFrame().get();
        until(() -> run.copyNewestFrame(frame));
        assertThat(frame.isFinite()).isTrue();
        run.restoreLastGood();
        assertThat(next(undone)).contains("greatest_pressure_kpa", "muscle_stiffness_n_per_m");
        steps(300);
        assertThat(run.scenario().toMap()).containsEntry("greatest_pressure_kpa", 1.8);
        run.pause();
        until(() -> !run.status().playing());
        Scenario recorded = run.recordedScenario();
        String hash = run.commandHash();
        // The way there leads through the bad change: it is repeated bit by bit, up to the state that was restored.
        assertThat(lungs.equals(LIVE_AGAIN) ? hashOfLiveRun(recorded) : hashOf(recorded))
                .isEqualTo(hash);
    }

    private String hashOfLiveRun(Scenario recorded) throws InterruptedException {
        run.close();
        run = new LiveRun(recorded, this);
        run.setSpeed(Double.POSITIVE_INFINITY);
        next(scenes);
        for (long i = 0; i < recorded.steps(); i++) {
            run.stepOnce();
        }
        until(() -> run.status().step() == recorded.steps());
        return run.commandHash();
    }

    private static String hashOf(Scenario recorded) {
        try (Simulation simulation = Runs.simulation(recorded)) {
            while (simulation.steps() < recorded.steps()) {
                simulation.step();
            }
            return simulation.stateHash();
        }
    }

    /** Runs until a change that no body bears has made the run diverge. */
    private void diverge() throws InterruptedException {
        start("preset=cough");
        next(scenes);
        run.setSpeed(Double.POSITIVE_INFINITY);
        run.play();
        steps(100);
        change(UNBEARABLE);
        next(divergences);
        assertThat(run.isDiverged()).isTrue();
    }

    @Test
    void afterADivergenceWhatIsChangedByHandIsKept() throws InterruptedException {
        diverge();
        change("area_density_kg_per_m2=300", "greatest_pressure_kpa=1.5", "damping_rate_per_s=5");
        run.restoreLastGood();
        steps(100);
        assertThat(run.isDiverged()).isFalse();
        assertThat(run.scenario().toMap()).containsEntry("greatest_pressure_kpa", 1.5);
        assertThat(undone).isEmpty();
    }

    /** The listener of a run may hold the breath until the very step before the run begins again with another. */
    @Test
    void aHoldThatFallsDueAtTheLastMomentIsNotThatOfTheRunThatBegins() throws InterruptedException {
        start();
        next(scenes);
        change("hold=true");
        BlockingQueue<Boolean> held = new LinkedBlockingQueue<>();
        run.restart(
                StepListener.Trigger.every(0.1),
                (frame, label) -> held.add(run.scenario().hold()));
        assertThat(next(held)).isFalse();
        assertThat(run.recordedScenario().toMap()).doesNotContainEntry("hold", true);
    }

    @Test
    void aDivergenceIsOverOnceTheRunBeginsAgain() throws InterruptedException {
        diverge();
        run.reset();
        until(() -> !run.isDiverged());
        change("greatest_pressure_kpa=2", "area_density_kg_per_m2=300", "damping_rate_per_s=5");
        run.restoreLastGood();
        run.commandHash();
        assertThat(run.isPlaying()).isFalse();
        assertThat(run.scenario().toMap()).containsEntry("greatest_pressure_kpa", 2.0);
        assertThat(undone).isEmpty();
    }

    /** Whatever steps a listener selects, at rest it shows the same moment as the picture. */
    @Test
    void atAPauseAndAtEachSingleStepTheListenerIsGivenTheStateOfThePicture() throws InterruptedException {
        start();
        Frame picture = next(scenes).newFrame().get();
        BlockingQueue<Long> given = new LinkedBlockingQueue<>();
        run.listenToSteps(StepListener.Trigger.every(100), new StepListener() {
            @Override
            public void onStep(Frame frame, RespiratoryPhase label) {}

            @Override
            public void onPause(Frame present, RespiratoryPhase label) {
                given.add(present.step());
            }
        });
        run.play();
        steps(10);
        run.pause();
        for (int step = 0; step < 3; step++) {
            long now = run.recordedScenario().steps();
            assertThat(given).containsExactly(now);
            given.clear();
            assertThat(run.copyNewestFrame(picture)).isTrue();
            assertThat(picture.step()).isEqualTo(now);
            run.stepOnce();
        }
    }
}
