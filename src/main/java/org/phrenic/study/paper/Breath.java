package org.phrenic.study.paper;

import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.simulation.Scenario;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;

/**
 * One simulated breath from end-expiration, as far as the paper says something of it.
 *
 * @param curves observables over the breath
 * @param row of the curves that is end-inspiration
 */
public record Breath(BreathSeries curves, int row) {
    /** One name of each group of measures that is wanted. */
    private static final List<String> WANTED = List.of("dome_right_vertebra", "tendon_bent_mm");

    static Breath of(Scenario scenario, Thorax thorax) {
        BreathSeries curves = PresetRun.of(scenario, thorax, PresetRun.SAMPLE_S, WANTED);
        return new Breath(curves, curves.deepest(0));
    }

    /** The same breath with another row taken for end-inspiration. */
    Breath lookedAt(int other) {
        return new Breath(curves, other);
    }

    /** A column at end-expiration. */
    double expired(String column) {
        return curves.value(column, curves.first(0));
    }

    /** A column at end-inspiration. */
    double inspired(String column) {
        return curves.value(column, row);
    }

    /** How far a column goes up in inspiration. */
    double rise(String column) {
        return inspired(column) - expired(column);
    }

    /** Mean of how far both domes go down in inspiration, mm. */
    double domesMm() {
        return -0.5 * (rise("dome_right_mm") + rise("dome_left_mm"));
    }
}
