package org.phrenic.study.sweep.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.OutputException;
import org.phrenic.study.sweep.RunMachine;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepResults;

/**
 * Runs what is left of a study. Each completed run is appended to the journal at once; the results are written anew now
 * and then, and at the end. A file of results that cannot be written before the end, such as one that another program
 * holds open, does not stop the study. A shard writes its journal only.
 */
public final class SweepRunner {
    /** Least time between two files of results before the end, s. */
    private static final double LEAST_INTERVAL_S = 5;

    private static final double TELL_INTERVAL_S = 1;
    /** Writing the results takes at most this share of the time. */
    private static final double WRITING_SHARE = 0.01;

    private final SweepFolder folder;
    private final Shard shard;
    private final SweepExecutor executor;
    private final ProgressListener progress;
    private final List<RunRow> rows = new ArrayList<>();
    private final long begun = System.nanoTime();
    private int computed;
    private final double leastIntervalS;
    private double renewAtS;
    private double tellAtS;
    private boolean isRefusalTold;

    private SweepRunner(
            SweepFolder folder, Shard shard, SweepExecutor executor, ProgressListener progress, double leastIntervalS) {
        this.leastIntervalS = leastIntervalS;
        renewAtS = leastIntervalS;
        this.folder = folder;
        this.shard = shard;
        this.executor = executor;
        this.progress = progress;
    }

    /** Runs what is left of a shard and returns all results in the folder. */
    public static SweepResults run(SweepFolder folder, Shard shard, SweepExecutor executor, ProgressListener progress) {
        return run(folder, shard, executor, progress, LEAST_INTERVAL_S);
    }

    /**
     * As {@link #run(SweepFolder, Shard, SweepExecutor, ProgressListener)}.
     *
     * @param leastIntervalS least time between two files of results before the end, s
     */
    static SweepResults run(
            SweepFolder folder, Shard shard, SweepExecutor executor, ProgressListener progress, double leastIntervalS) {
        return new SweepRunner(folder, shard, executor, progress, leastIntervalS).run();
    }

    private SweepResults run() {
        SweepResults before = folder.results();
        try (SweepJournal journal = folder.journal(shard)) {
            rows.addAll(before.rows());
            List<Integer> mine = IntStream.range(0, folder.plan().size())
                    .filter(shard::contains)
                    .boxed()
                    .toList();
            List<Integer> pending = mine.stream().filter(i -> !before.has(i)).toList();
            int known = mine.size() - pending.size();
            if (known > 0) {
                progress.note(known + " of " + mine.size() + " runs are in the journal");
            }
            if (!pending.isEmpty()) {
                tellOtherBuilds(before);
                progress.resumed(known);
                executor.run(folder.plan(), pending, row -> completed(row, journal, known, mine.size()));
            }
        }
        SweepResults results = folder.results();
        if (shard.count() == 1) {
            write(results);
        }
        return results;
    }

    /** Another build may give other results, and no run says which of them it has. */
    private void tellOtherBuilds(SweepResults before) {
        Set<String> others = before.programs();
        others.remove(RunMachine.program());
        if (!others.isEmpty()) {
            progress.note("found runs of another build of the program in the journal (" + String.join("; ", others)
                    + "), expected those of this one (" + RunMachine.program()
                    + "): a new folder has all runs of one build");
        }
    }

    private synchronized void completed(RunRow row, SweepJournal journal, int known, int total) {
        journal.add(row);
        rows.add(row);
        computed++;
        tell(row, known, total);
        if (shard.count() == 1 && elapsedS() > renewAtS) {
            double start = elapsedS();
            writeSoFar();
            renewAtS = elapsedS() + Math.max(leastIntervalS, (elapsedS() - start) / WRITING_SHARE);
        }
    }

    /** The runs are safe in the journal: a file that cannot be written is told once. */
    private void writeSoFar() {
        try {
            write(new SweepResults(folder.plan(), rows));
        } catch (OutputException e) {
            if (!isRefusalTold) {
                isRefusalTold = true;
                progress.note(e.getMessage() + "; the study goes on, and its results are written again later");
            }
        }
    }

    private void tell(RunRow row, int known, int total) {
        boolean last = known + computed == total;
        if (row.isFailed() || last || elapsedS() > tellAtS) {
            String point = folder.plan().points().get(row.index()).description();
            progress.done(known + computed, total, row.isFailed() ? point + ": failed: " + row.failure() : point);
            tellAtS = elapsedS() + TELL_INTERVAL_S;
        }
    }

    private void write(SweepResults results) {
        folder.write(results, elapsedS(), computed, executor.width());
    }

    private double elapsedS() {
        return (System.nanoTime() - begun) * 1e-9;
    }
}
