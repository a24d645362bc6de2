package org.phrenic.fit;

import java.util.List;
import java.util.Map;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.scenario.Scenario;

/**
 * The result of a fit.
 *
 * @param values of the parameters, in the order of the setup
 * @param bestMm the objective: weighted mean distance from the targets
 * @param initialMm the objective at end-expiration
 * @param untunedMm the objective at the start of the search
 * @param sensitivity to each parameter near the values found; empty if not requested
 * @param observed observables of the fitted body by name
 * @param scenario with which {@code phrenic run} reaches the same state
 * @param reproduced whether that scenario was run and gave the same state bit by bit
 * @param trials objective of every evaluation, in order
 * @param ended why the search ended, in words
 * @param cpuPerEvaluationS mean processor time of the evaluations of this run; NaN if all were in the journal
 * @param wallS duration of this run, s
 */
public record FitResult(
        FitSetup setup,
        double[] values,
        double bestMm,
        double initialMm,
        double untunedMm,
        List<TargetResult> targets,
        List<Effect> sensitivity,
        Map<String, Double> observed,
        Scenario scenario,
        boolean reproduced,
        double[] trials,
        String ended,
        double cpuPerEvaluationS,
        double wallS) {

    /**
     * Distances from a target: initial at end-expiration, residual of the fitted body; of the whole surface, and of the
     * two halves, null if none is held out.
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
     * Effect of a parameter near the values found.
     *
     * @param step by which it is moved, in its unit
     * @param belowMm objective with a step less; NaN beyond the bound
     * @param aboveMm objective with a step more; NaN beyond the bound
     */
    public record Effect(FitParameter parameter, double step, double belowMm, double aboveMm) {}

    /** Mean residual over mean initial distance. */
    public double ratio() {
        return bestMm / initialMm;
    }
}
