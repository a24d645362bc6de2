package org.phrenic.cluster;

import java.util.List;
import java.util.function.Consumer;
import org.apache.spark.SparkDriverExecutionException;
import org.apache.spark.SparkException;
import org.apache.spark.api.java.JavaSparkContext;
import org.phrenic.file.BadInputException;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.run.SweepExecutor;
import scala.reflect.ClassTag$;

/**
 * Computes runs as tasks of one Spark job (RDD API). Results come back task by task, so that the journal of the driver
 * grows as runs are completed.
 */
final class SparkSweep implements SweepExecutor {
    /** Tasks for each core of the cluster, so that the last ones end at about the same time. */
    private static final int TASKS_PER_CORE = 32;
    /** Tasks that any driver handles without delay, whatever the number of cores, which is not known at the start. */
    private static final int EASY_TASKS = 10_000;

    private final JavaSparkContext context;

    SparkSweep(JavaSparkContext context) {
        this.context = context;
    }

    @Override
    public void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done) {
        try {
            context.sc()
                    .runJob(
                            context.parallelize(pending, tasks(pending.size(), width()))
                                    .rdd(),
                            new RunTask(plan.study().resolved()),
                            new RowsHandler(done),
                            ClassTag$.MODULE$.apply(RunRow[].class));
        } catch (Exception failure) { // runJob throws SparkException without declaring it
            if (failure instanceof SparkDriverExecutionException
                    && failure.getCause() instanceof RuntimeException own) {
                throw own; // the journal or the report could not be written, which is no failure of the cluster
            }
            if (failure instanceof SparkException) {
                throw new BadInputException(
                        "--master " + context.master() + ": Spark ended the study (" + SparkService.sentence(failure)
                                + "); the runs that are done are kept, and the same command resumes it",
                        failure);
            }
            throw failure;
        }
    }

    /** Number of tasks for a number of runs on cores. */
    static int tasks(int runs, int cores) {
        return Math.min(runs, Math.max(EASY_TASKS, TASKS_PER_CORE * cores));
    }

    /** Cores of the executors that have come so far; a standalone master has two before the first. */
    @Override
    public int width() {
        return context.defaultParallelism();
    }

    @Override
    public void close() {
        context.close();
    }
}
