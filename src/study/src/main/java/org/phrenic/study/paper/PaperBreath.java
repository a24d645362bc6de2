package org.phrenic.study.paper;

import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;

/**
 * One simulated breath from end-expiration, for comparison with the paper.
 *
 * @param series observables over the breath
 * @param endInspirationRow row of the series at end-inspiration
 */
public record PaperBreath(BreathSeries series, int endInspirationRow) {
    /** One observable of each measure group that is needed. */
    private static final List<String> WANTED = List.of("dome_right_vertebra", "tendon_bent_mm");

    static PaperBreath of(Scenario scenario, Thorax thorax) {
        BreathSeries curves = PresetRun.of(scenario, thorax, PresetRun.SAMPLE_S, WANTED);
        return new PaperBreath(curves, curves.endInspirationRow(0));
    }

    /** A copy with another row as end-inspiration. */
    PaperBreath withEndInspirationRow(int other) {
        return new PaperBreath(series, other);
    }

    /** Value of a column at end-expiration. */
    double atEndExpiration(String column) {
        return series.value(column, series.endExpirationRow(0));
    }

    /** Value of a column at end-inspiration. */
    double atEndInspiration(String column) {
        return series.value(column, endInspirationRow);
    }

    /** Change of a column from end-expiration to end-inspiration. */
    double change(String column) {
        return atEndInspiration(column) - atEndExpiration(column);
    }

    /** Descent of the domes in inspiration, mean of both sides, mm. */
    double domeDescentMm() {
        return -0.5 * (change("dome_right_mm") + change("dome_left_mm"));
    }
}
