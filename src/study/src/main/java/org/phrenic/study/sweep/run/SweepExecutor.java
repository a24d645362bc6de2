package org.phrenic.study.sweep.run;

import java.util.List;
import java.util.function.Consumer;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepPlan;

/** Computes runs of a plan somewhere. */
public interface SweepExecutor extends AutoCloseable {
    /**
     * Computes runs.
     *
     * @param pending indices of the runs
     * @param done receives each run as it is completed, in any order, from any thread
     */
    void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done);

    /** Runs that are computed at the same time. */
    int width();

    /** Releases what the executor holds. */
    @Override
    default void close() {}
}
