package org.phrenic.study.sweep.run;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.report.StudyCost;

/** Measures what a way of running a study costs: elapsed time and processor time of this process. */
public final class StudyMeasurement {
    private static final OperatingSystemMXBean PROCESS =
            ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

    private StudyMeasurement() {}

    /**
     * Runs a study from its first to its last run.
     *
     * @param folder of the study, which must not have begun
     * @param inProcess whether the executor computes in this process
     */
    public static StudyCost measure(
            String way,
            Path folder,
            SweepPlan plan,
            SweepExecutor executor,
            boolean inProcess,
            ProgressListener progress) {
        return measure(
                way,
                executor::width,
                inProcess,
                () -> SweepRunner.run(SweepFolder.of(folder, plan), Shard.WHOLE, executor, progress));
    }

    /** Runs a study as shards one after another and merges them; each shard makes its own plan and bodies. */
    public static StudyCost ofShards(
            String way, Path folder, SweepPlan plan, int shards, int threads, ProgressListener progress) {
        return measure(way, () -> threads, true, () -> {
            for (int k = 0; k < shards; k++) {
                SweepFolder part = SweepFolder.of(folder, SweepPlan.of(plan.study()));
                SweepRunner.run(part, new Shard(k, shards), new ThreadExecutor(threads), progress);
            }
            SweepFolder whole = SweepFolder.existing(folder);
            SweepResults results = whole.results();
            whole.write(results, 0, 0, 1);
            return results;
        });
    }

    /** @param width runs at a time, asked when the study is done: a cluster grows meanwhile */
    private static StudyCost measure(String way, IntSupplier width, boolean inProcess, Supplier<SweepResults> study) {
        long begun = System.nanoTime();
        long processor = PROCESS.getProcessCpuTime();
        SweepResults results = study.get();
        double processorS = inProcess ? (PROCESS.getProcessCpuTime() - processor) * 1e-9 : Double.NaN;
        double elapsedS = (System.nanoTime() - begun) * 1e-9;
        return new StudyCost(way, width.getAsInt(), elapsedS, processorS, results);
    }
}
