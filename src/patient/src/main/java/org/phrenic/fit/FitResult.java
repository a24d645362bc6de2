package org.phrenic.fit;

import java.util.List;
import java.util.Map;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.scenario.Scenario;

/**
 * What a fit found.
 *
 * @param setup what was asked
 * @param values of the parameters, in their order
 * @param bestMm mean distance of the targets that count, by their weights, on what was fitted to
 * @param initialMm the same of the body at end-expiration
 * @param untunedMm the same with the parameters where the search began
 * @param targets each target before and after
 * @param sensitivity what each parameter does near the values found; empty if that was not asked for
 * @param observed what the fitted body does: observables by their names
 * @param scenario takes the body to the same state, as {@code phrenic run} does
 * @param reproduced whether it was run and gave the same state bit by bit
 * @param trials the distance of every evaluation, in order
 * @param ended why the search ended, in words
 * @param cpuPerEvaluationS processor time of an evaluation made now, mean; NaN where all were known
 * @param wallS time that it took now, s
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
     * A target before and after.
     *
     * @param initial body at end-expiration, all of the surface
     * @param residual body as fitted, all of the surface
     * @param initialHeldOut body at end-expiration, the half held out; null where none is
     * @param residualHeldOut body as fitted, the half held out; null where none is
     * @param residualFitted body as fitted, the half fitted to; null where none is held out
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
     * What a parameter does near the values found.
     *
     * @param parameter which
     * @param step by how much it was moved, in its unit
     * @param belowMm mean distance with so much less; NaN beyond the bound
     * @param aboveMm mean distance with so much more; NaN beyond the bound
     */
    public record Effect(FitParameter parameter, double step, double belowMm, double aboveMm) {}

    /** Mean residual over mean initial distance. */
    public double ratio() {
        return bestMm / initialMm;
    }
}
