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
    /** Tasks that any driver handles without delay. */
    private static final int EASY_TASKS = 1000;

    private final JavaSparkContext context;

    SparkSweep(JavaSparkContext context) {
        this.context = context;
    }

    @Override
    public void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done) {
        int tasks = Math.min(pending.size(), Math.max(EASY_TASKS, TASKS_PER_CORE * width()));
        try {
            context.sc()
                    .runJob(
                            context.parallelize(pending, tasks).rdd(),
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

    @Override
    public int width() {
        return context.defaultParallelism();
    }

    @Override
    public void close() {
        context.close();
    }
}
