package org.phrenic.study.sweep.run;

import java.util.List;
import java.util.function.Consumer;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepPoint;

/**
 * Computes runs on threads of this machine, one run a thread.
 *
 * @param width number of threads
 */
public record ThreadExecutor(int width) implements SweepExecutor {
    private static final ProgressListener SILENT = new ProgressListener() {
        @Override
        public void done(int count, int total, String what) {
            // The caller counts.
        }
    };

    @Override
    public void run(SweepPlan plan, List<Integer> pending, Consumer<RunRow> done) {
        List<SweepPoint> points = plan.points();
        List<BatchRunner.Job<Integer>> jobs = pending.stream()
                .map(index -> new BatchRunner.Job<>(String.valueOf(index), () -> {
                    done.accept(RunRow.of(plan.model(), points.get(index)));
                    return index;
                }))
                .toList();
        try {
            BatchRunner.run(jobs, width, SILENT);
        } catch (BadInputException unread) {
            throw new BadInputException(
                    unread.getMessage() + "; the runs that are done are kept, and the same command resumes the study",
                    unread);
        }
    }
}
