package org.phrenic.study.sweep.run;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;

/**
 * What one way of running a study costs.
 *
 * @param way such as "2 threads"
 * @param width runs at a time
 * @param elapsedS from the plan to the written results, s
 * @param processorS processor time of this process meanwhile, s; NaN if other processes compute
 * @param results of the study
 */
public record StudyCost(String way, int width, double elapsedS, double processorS, SweepResults results) {
    private static final OperatingSystemMXBean PROCESS =
            ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

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
                executor.width(),
                inProcess,
                () -> SweepRunner.run(SweepFolder.of(folder, plan), Shard.WHOLE, executor, progress));
    }

    /** Runs a study as shards one after another and merges them; each shard makes its own plan and bodies. */
    public static StudyCost ofShards(
            String way, Path folder, SweepPlan plan, int shards, int threads, ProgressListener progress) {
        return measure(way, threads, true, () -> {
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

    private interface Study {
        SweepResults run();
    }

    private static StudyCost measure(String way, int width, boolean inProcess, Study study) {
        long begun = System.nanoTime();
        long processor = PROCESS.getProcessCpuTime();
        SweepResults results = study.run();
        double processorS = inProcess ? (PROCESS.getProcessCpuTime() - processor) * 1e-9 : Double.NaN;
        return new StudyCost(way, width, (System.nanoTime() - begun) * 1e-9, processorS, results);
    }

    /** Share of the threads' time in which they computed: processor time / (elapsed time x threads). */
    public double busyShare() {
        return processorS / (elapsedS * width);
    }

    /** Elapsed time over the runs' own time / threads; 1 without any cost of the study itself. */
    public double overhead() {
        return elapsedS * width / results.wallS();
    }

    /** Whether a study has the same rows but for wall times and machines: responses, series, hashes, failures. */
    public boolean hasRowsOf(StudyCost other) {
        List<RunRow> mine = results.rows();
        List<RunRow> others = other.results.rows();
        return mine.size() == others.size()
                && IntStream.range(0, mine.size()).allMatch(i -> mine.get(i).hasResultOf(others.get(i)));
    }
}
