package org.phrenic.study.paper;

import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;

/**
 * One simulated breath from end-expiration, as far as the paper says something of it.
 *
 * @param series observables over the breath
 * @param endInspirationRow of the curves that is end-inspiration
 */
public record PaperBreath(BreathSeries series, int endInspirationRow) {
    /** One name of each group of measures that is wanted. */
    private static final List<String> WANTED = List.of("dome_right_vertebra", "tendon_bent_mm");

    static PaperBreath of(Scenario scenario, Thorax thorax) {
        BreathSeries curves = PresetRun.of(scenario, thorax, PresetRun.SAMPLE_S, WANTED);
        return new PaperBreath(curves, curves.endInspirationRow(0));
    }

    /** The same breath with another row taken for end-inspiration. */
    PaperBreath withEndInspirationRow(int other) {
        return new PaperBreath(series, other);
    }

    /** A column at end-expiration. */
    double atEndExpiration(String column) {
        return series.value(column, series.endExpirationRow(0));
    }

    /** A column at end-inspiration. */
    double atEndInspiration(String column) {
        return series.value(column, endInspirationRow);
    }

    /** How far a column goes up in inspiration. */
    double change(String column) {
        return atEndInspiration(column) - atEndExpiration(column);
    }

    /** Mean of how far both domes go down in inspiration, mm. */
    double domeDescentMm() {
        return -0.5 * (change("dome_right_mm") + change("dome_left_mm"));
    }
}
