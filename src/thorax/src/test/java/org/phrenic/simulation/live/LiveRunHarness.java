package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/** A run that each test starts and that is closed after it. The sheet alone is stepped, for it is quick. */
abstract class LiveRunHarness extends LiveRunEvents {
    private static final String[] SMALL = {
        "resolution=low", "mesh_vertices=3000", "lungs=embedded", "sternum=kinematic", "threads=1"
    };

    LiveRun run;
    /** Whether the run played when it last said that something has changed. */
    volatile boolean playingShown;

    final LiveRun start(String... more) {
        run = new LiveRun(Scenario.defaults().with(SMALL).with(more), this);
        return run;
    }

    @Override
    public void changed() {
        LiveRun now = run;
        playingShown = now != null && now.isPlaying();
    }

    @AfterEach
    void end() {
        run.close();
    }

    static void until(BooleanSupplier what) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
        while (!what.getAsBoolean()) {
            assertThat(System.nanoTime()).as("patience").isLessThan(end);
            TimeUnit.MILLISECONDS.sleep(2);
        }
    }

    final void change(String... assignments) {
        run.change(List.of(assignments).stream().map(Assignment::parse).toList());
    }

    final void steps(long more) throws InterruptedException {
        long goal = run.status().step() + more;
        until(() -> run.status().step() >= goal);
    }
}
