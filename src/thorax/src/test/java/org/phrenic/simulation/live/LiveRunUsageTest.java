package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** What a run takes of the process: wall time, threads and memory. */
@Isolated("measures the wall time, the memory and the threads of the process")
class LiveRunUsageTest extends LiveRunHarness {
    @Test
    void inRealTimeItGoesNoFasterAndTwiceAsFastIsTwice() throws InterruptedException {
        start();
        next(scenes);
        run.play();
        for (double speed : new double[] {1, 2}) {
            steps(50);
            // What a stall before this leaves to be made up is no part of the pace that begins here.
            long begun = System.nanoTime();
            run.setSpeed(speed);
            run.recordedScenario();
            double from = run.status().timeS();
            TimeUnit.MILLISECONDS.sleep(400);
            double went = run.status().timeS() - from;
            double wall = (System.nanoTime() - begun) * 1e-9;
            // A turn of the loop more or less; slower it may be, where the machine is busy.
            assertThat(went).isPositive().isLessThan(speed * (wall + 0.05));
        }
    }

    @Test
    void closedItLeavesNoThreadAndResetsAndChangesLeaveNoMemory() throws InterruptedException {
        start();
        next(scenes);
        run.setSpeed(Double.POSITIVE_INFINITY);
        run.play();
        long settled = 0;
        for (int round = 0; round < 32; round++) {
            change("depth=" + (0.5 + round % 10 * 0.1), "muscle_activation=" + (0.3 + round % 5 * 0.05));
            steps(30);
            run.reset();
            // Answered after the reset.
            run.recordedScenario();
            if (round == 11) {
                settled = used();
            }
        }
        // A scene is some 8 MB: not one is left behind by twenty resets.
        assertThat(used() - settled).isLessThan(15L << 20);
        change("resolution=medium");
        run.close();
        assertThat(Thread.getAllStackTraces().keySet())
                .extracting(Thread::getName)
                .noneMatch(name -> name.startsWith("phrenic-simulation") || name.startsWith("phrenic-loader"));
        assertThat(run.commandHash()).as("still answers").hasSize(64);
    }

    private static long used() {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return runtime.totalMemory() - runtime.freeMemory();
    }
}
