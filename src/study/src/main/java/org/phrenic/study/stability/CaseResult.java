package org.phrenic.study.stability;

import java.util.Map;
import org.phrenic.engine.integrator.IntegratorKind;

/**
 * One stability case under one integrator.
 *
 * @param caseKey which case
 * @param integrator the scheme
 * @param outcome how it ended
 * @param sentence what was refused, diverged or refined; empty where nothing was
 * @param requestedS simulated time asked for, s
 * @param simulatedS simulated time at the end, s
 * @param dtS time step, s; NaN where it was refused
 * @param substeps per step at the end; 0 where it was refused
 * @param found values of the measures; those that were not measured are missing
 */
public record CaseResult(
        String caseKey,
        IntegratorKind integrator,
        Outcome outcome,
        String sentence,
        double requestedS,
        double simulatedS,
        double dtS,
        int substeps,
        Map<StabilityMeasure, Double> found) {
    /** How a case ended. */
    public enum Outcome {
        /** Every measure stayed within the bounds of the case. */
        STABLE("stable"),
        /** A diverged state was detected, an earlier one was restored, and what followed held the bounds. */
        RECOVERED("recovered"),
        /** The scene was refused before it ran, in a sentence that says why. */
        REFUSED("refused"),
        /** A bound was violated and nothing was reported: what must not be. */
        SILENT_FAILURE("FAILED SILENTLY");

        private final String label;

        Outcome(String label) {
            this.label = label;
        }

        /** Name in reports. */
        public String label() {
            return label;
        }
    }

    static CaseResult refused(String caseKey, IntegratorKind integrator, double requestedS, String sentence) {
        return new CaseResult(caseKey, integrator, Outcome.REFUSED, sentence, requestedS, 0, Double.NaN, 0, Map.of());
    }

    /** Whether it ended before its time because it had spent the evaluations it may. */
    boolean endedEarly() {
        return outcome != Outcome.REFUSED && outcome != Outcome.SILENT_FAILURE && simulatedS < requestedS - dtS;
    }

    /** NaN where it was not measured. */
    double value(StabilityMeasure measure) {
        return found.getOrDefault(measure, Double.NaN);
    }
}
