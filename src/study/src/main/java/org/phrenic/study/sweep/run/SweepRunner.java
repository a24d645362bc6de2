package org.phrenic.study.sweep.run;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepResults;

/**
 * Runs what is left of a study. Each completed run is appended to the journal at once; the results are written anew now
 * and then, and at the end. A shard writes its journal only.
 */
public final class SweepRunner {
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
    private double renewAtS = LEAST_INTERVAL_S;
    private double tellAtS;

    private SweepRunner(SweepFolder folder, Shard shard, SweepExecutor executor, ProgressListener progress) {
        this.folder = folder;
        this.shard = shard;
        this.executor = executor;
        this.progress = progress;
    }

    /** Runs what is left of a shard and returns all results in the folder. */
    public static SweepResults run(SweepFolder folder, Shard shard, SweepExecutor executor, ProgressListener progress) {
        return new SweepRunner(folder, shard, executor, progress).run();
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
                executor.run(folder.plan(), pending, row -> completed(row, journal, known, mine.size()));
            }
        }
        SweepResults results = folder.results();
        if (shard.count() == 1) {
            write(results);
        }
        return results;
    }

    private synchronized void completed(RunRow row, SweepJournal journal, int known, int total) {
        journal.add(row);
        rows.add(row);
        computed++;
        tell(row, known, total);
        if (shard.count() == 1 && elapsedS() > renewAtS) {
            double start = elapsedS();
            write(new SweepResults(folder.plan(), rows));
            renewAtS = elapsedS() + Math.max(LEAST_INTERVAL_S, (elapsedS() - start) / WRITING_SHARE);
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
