package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.UserCache;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;

/** Errors of the virtual machine, such as full memory, while a scene runs or loads. */
class ErrorsInARunTest extends LiveRunEvents {
    private static final Scenario SMALL = Scenario.defaults()
            .with("resolution=low", "mesh_vertices=3000", "lungs=embedded", "sternum=kinematic", "threads=1");

    private final AtomicReference<Error> ofNextBody = new AtomicReference<>();
    private LiveRun run;

    private void start() {
        run = new LiveRun(SMALL, this);
    }

    @Override
    public void body(LiveScene atRest) {
        Error error = ofNextBody.getAndSet(null);
        if (error != null) {
            throw error;
        }
    }

    @AfterEach
    void end() {
        if (run != null) {
            run.close();
        }
    }

    /** A listener that runs out of memory at the first step, and where that is once more. */
    private static StepListener fullMemory(boolean besideTheRun) {
        return new StepListener() {
            @Override
            public void onStep(Frame frame, RespiratoryPhase label) {
                throw new OutOfMemoryError("Java heap space");
            }

            @Override
            public boolean maySeeFrameLater() {
                return besideTheRun;
            }
        };
    }

    private void requireToldAndAlive() throws InterruptedException {
        assertThat(next(failures)).startsWith("The simulation stopped").contains("not enough memory", "-Xmx");
        assertThat(run.isPlaying()).isFalse();
        assertThat(run.commandHash()).hasSize(64);
        run.change(List.of(Assignment.parse("links_per_node=2")));
        assertThat(next(scenes).id()).isEqualTo(2);
        assertThat(failures).isEmpty();
    }

    @Test
    void aRunThatHasNoMemorySaysSoAndAnotherSceneLoads() throws InterruptedException {
        start();
        next(scenes);
        run.play();
        run.restart(StepListener.Trigger.every(100), fullMemory(false));
        requireToldAndAlive();
    }

    @Test
    void aFrameThatHasNoMemoryIsToldLikewise() throws InterruptedException {
        start();
        next(scenes);
        run.play();
        run.restart(StepListener.Trigger.every(100), fullMemory(true));
        requireToldAndAlive();
    }

    /** The run is paused at its start, so that no other frame comes between that one and the scene that follows. */
    @Test
    void aSceneTakesThePlaceOfOneWhoseLastFrameHadNoMemory() throws InterruptedException {
        start();
        next(scenes);
        run.restart(StepListener.Trigger.every(100), fullMemory(true));
        assertThat(run.commandHash()).as("the run has begun again").hasSize(64);
        run.change(List.of(Assignment.parse("links_per_node=2")));
        assertThat(next(scenes).id()).isEqualTo(2);
        assertThat(next(failures)).startsWith("The simulation stopped").contains("not enough memory");
    }

    @Test
    void theThreadOfFramesEndsAfterOneThatFailed() throws InterruptedException {
        AtomicReference<Thread> thread = new AtomicReference<>();
        FrameWriter writer = new FrameWriter();
        writer.start(() -> {
            thread.set(Thread.currentThread());
            throw new OutOfMemoryError("Java heap space");
        });
        assertThatExceptionOfType(OutOfMemoryError.class).isThrownBy(writer::close);
        thread.get().join(TimeUnit.SECONDS.toMillis(PATIENCE_S));
        assertThat(thread.get().isAlive()).isFalse();
    }

    @Test
    void aLoadThatEndsWithAnErrorIsToldAndIsOver() throws InterruptedException {
        ofNextBody.set(new NoClassDefFoundError("org/phrenic/Missing"));
        start();
        assertThat(next(failures)).contains("cannot be loaded", "org/phrenic/Missing");
        assertThat(run.isLoading()).isFalse();
        run.load(SMALL);
        assertThat(next(scenes).isAtRest()).isFalse();
    }

    /** The threads of a scene are in the group of the thread that loads it. */
    @Test
    void aSceneThatEndsWithAnErrorLeavesNoThreads() throws InterruptedException {
        ThreadGroup group = new ThreadGroup("a scene");
        AtomicInteger whileSettling = new AtomicInteger();
        SimulationRun.Progress full = new SimulationRun.Progress() {
            @Override
            public void advanced(double simulatedS, double totalS, double stepsPerS) {}

            @Override
            public void settling(double doneS, double totalS) {
                whileSettling.set(group.activeCount());
                throw new OutOfMemoryError("Java heap space");
            }
        };
        Scenario parallel = SMALL.with("threads=2", "time_step_s=0.001");
        FutureTask<Simulation> loaded = new FutureTask<>(
                () -> Simulation.of(parallel, SimulationRun.loadThorax(parallel), UserCache.off(), full));
        new Thread(group, loaded).start();
        assertThatThrownBy(() -> loaded.get(PATIENCE_S, TimeUnit.SECONDS)).hasCauseInstanceOf(OutOfMemoryError.class);
        assertThat(whileSettling).as("the loading thread and a worker").hasValueGreaterThan(1);
        Thread[] left = new Thread[2 * whileSettling.get()];
        int count = group.enumerate(left);
        for (int i = 0; i < count; i++) {
            left[i].join(TimeUnit.SECONDS.toMillis(PATIENCE_S));
            assertThat(left[i].isAlive()).as(left[i].getName()).isFalse();
        }
    }
}
