package org.phrenic.fit;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.scenario.Scenario;

/**
 * The result of a fit.
 *
 * @param values parameter values, in the order of the setup
 * @param bestMm objective of the fitted body, mm: the weighted mean distance from the targets
 * @param initialMm objective at end-expiration, mm
 * @param untunedMm objective at the start of the search, mm; NaN if that breath failed
 * @param landmarks errors inside the lungs, if there are landmarks
 * @param sensitivity effect of each parameter near the fitted values; empty if not requested
 * @param observed observables of the fitted body by name
 * @param scenario scenario with which {@code phrenic run} reaches the same state
 * @param reproduced whether that scenario was run and gave a bit-identical state
 * @param search how the search went
 */
public record FitResult(
        FitSetup setup,
        double[] values,
        double bestMm,
        double initialMm,
        double untunedMm,
        List<TargetResult> targets,
        Optional<Landmarks.Errors> landmarks,
        List<Effect> sensitivity,
        Map<String, Double> observed,
        Scenario scenario,
        boolean reproduced,
        Search search) {

    /**
     * The course of a search.
     *
     * @param trials objective of every evaluation, in order
     * @param ended why the search ended, as text
     * @param failures breaths of the search that failed, by reason
     * @param warnings what makes the result doubtful, one sentence each
     * @param cpuPerEvaluationS mean processor time per evaluation of this run, s; NaN if all evaluations came from the
     *     journal
     * @param wallS wall-clock time of this run, s
     */
    public record Search(
            double[] trials,
            String ended,
            List<FailedBreaths> failures,
            List<String> warnings,
            double cpuPerEvaluationS,
            double wallS) {}

    /**
     * Distances from a target. Initial distances are at end-expiration, residual distances are those of the fitted
     * body. They are given for the whole surface and for its two halves. The halves are null if none is held out.
     */
    public record TargetResult(
            FitTarget target,
            FitDistances initial,
            FitDistances residual,
            FitDistances initialHeldOut,
            FitDistances residualHeldOut,
            FitDistances residualFitted) {

        /** Mean residual over mean initial distance. */
        public double ratio() {
            return residual.mean() / initial.mean();
        }
    }

    /**
     * Effect of a parameter near the fitted values.
     *
     * @param step change of the parameter, in its unit
     * @param belowMm objective with the parameter decreased by one step, mm; NaN outside the bounds, infinite if that
     *     breath fails
     * @param aboveMm the same with the parameter increased by one step
     */
    public record Effect(FitParameter parameter, double step, double belowMm, double aboveMm) {}

    /** Mean residual over mean initial distance. */
    public double ratio() {
        return bestMm / initialMm;
    }
}
