package org.phrenic.study.stability;

import java.util.Map;
import org.phrenic.engine.integrator.IntegratorKind;

/**
 * Result of one stability case under one integrator.
 *
 * @param caseKey key of the case
 * @param integrator scheme
 * @param outcome how the case ended
 * @param sentence description of a refusal, divergence, step refinement, bound that was violated, or breath that
 *     repeats no other; empty if there was none
 * @param requestedS requested simulated time, s
 * @param simulatedS simulated time at the end, s
 * @param dtS time step, s; NaN if the scene was not made
 * @param substeps per step at the end; 0 if the scene was not made
 * @param found values of the measures; measures that were not evaluated are missing
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
        /** All measures stayed within the bounds of the case. */
        STABLE("stable"),
        /** A divergence was detected, an earlier state was restored, and the bounds held afterwards. */
        RECOVERED("recovered"),
        /** A divergence was detected and undone, but at the end the body was not back where it began. */
        NOT_RETURNED("DID NOT RETURN"),
        /** The scene was refused before the run, with a reason. */
        REFUSED("refused"),
        /** The settings contradict each other on purpose; the engine noticed it and the run ended with its sentence. */
        NOTICED("noticed, stopped"),
        /** A fault was noticed that nothing could undo, so the run ended with a sentence. */
        STOPPED("STOPPED"),
        /** A bound was violated without any report. This must not occur. */
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

    /** The result of a case whose scene was not made. */
    static CaseResult unmade(
            String caseKey, IntegratorKind integrator, Outcome outcome, double requestedS, String sentence) {
        return new CaseResult(caseKey, integrator, outcome, sentence, requestedS, 0, Double.NaN, 0, Map.of());
    }

    /** Whether the run ended early because its budget of force evaluations was spent. */
    boolean endedEarly() {
        return (outcome == Outcome.STABLE || outcome == Outcome.RECOVERED) && simulatedS < requestedS - dtS;
    }

    /** Whether the outcome is one that must not occur. */
    boolean fails() {
        return outcome == Outcome.SILENT_FAILURE || outcome == Outcome.NOT_RETURNED || outcome == Outcome.STOPPED;
    }

    /** Value of a measure; NaN if it was not evaluated. */
    double value(StabilityMeasure measure) {
        return found.getOrDefault(measure, Double.NaN);
    }
}
