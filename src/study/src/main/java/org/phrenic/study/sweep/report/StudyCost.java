package org.phrenic.study.sweep.report;

import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.study.sweep.RunRow;
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
    /** Whether the study was computed in this process, so that its processor time is known. */
    public boolean hasProcessorTime() {
        return Double.isFinite(processorS);
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
