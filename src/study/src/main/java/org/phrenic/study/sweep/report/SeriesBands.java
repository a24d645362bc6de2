package org.phrenic.study.sweep.report;

import java.util.List;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepOutcome;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.index.Quantiles;

/** Bands of the recorded observables over the time of a run: median, middle half and 95 % of the runs. */
final class SeriesBands {
    private static final double WIDTH = 640;
    private static final double HEIGHT = 280;
    private static final double[] SHARES = {0.025, 0.25, 0.5, 0.75, 0.975};
    private static final int PERCENT = 100;

    private final SweepResults results;

    SeriesBands(SweepResults results) {
        this.results = results;
    }

    /** Quantiles of a series: one row a share, one column a time. */
    double[][] quantiles(int series) {
        double[][] bands = new double[SHARES.length][SweepOutcome.SERIES_POINTS];
        List<RunRow> rows = results.rows();
        for (int t = 0; t < SweepOutcome.SERIES_POINTS; t++) {
            int at = t;
            double[] values = rows.stream()
                    .mapToDouble(row -> row.outcome().series()[series][at])
                    .toArray();
            double[] q = Quantiles.of(values, SHARES);
            for (int s = 0; s < SHARES.length; s++) {
                bands[s][t] = q[s];
            }
        }
        return bands;
    }

    void addTo(ReportDocument page) {
        List<String> names = results.plan().model().series();
        if (names.isEmpty() || results.done() == results.failed()) {
            return;
        }
        double[] time = new double[SweepOutcome.SERIES_POINTS];
        for (int t = 0; t < time.length; t++) {
            time[t] = (double) PERCENT * t / (time.length - 1);
        }
        page.section("Over time");
        for (int s = 0; s < names.size(); s++) {
            double[][] q = quantiles(s);
            CurveChart chart = new CurveChart(WIDTH, HEIGHT, "share of the run, %")
                    .band(time, q[0], q[4])
                    .band(time, q[1], q[3])
                    .curve(time, q[2], false);
            page.figure(
                    names.get(s) + ": median, middle half and 95 % of the runs.",
                    chart.picture("Band of " + names.get(s) + " over time", ""));
        }
    }
}
