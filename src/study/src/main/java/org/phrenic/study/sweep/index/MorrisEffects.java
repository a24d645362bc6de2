package org.phrenic.study.sweep.index;

import java.util.ArrayList;
import java.util.List;

/**
 * Elementary effects of a response: its change along a step of a Morris trajectory over the change of the factor. The
 * mean of the absolute effects (mu*, Campolongo et al. 2007, doi 10.1016/j.envsoft.2006.10.004) ranks the factors.
 * Their standard deviation (sigma) tells nonlinear or interacting factors.
 *
 * @param mu mean effect of each factor, in units of the response per unit of the factor's change
 * @param muStar mean absolute effect of each factor
 * @param sigma standard deviation of the effects of each factor
 */
public record MorrisEffects(List<Estimate> mu, List<Estimate> muStar, List<Estimate> sigma) {
    /**
     * Computes the effects. A step whose runs did not both succeed is left out.
     *
     * @param changes of the factors from each point to the next, trajectory after trajectory
     * @param responses one per point; NaN for a run that failed or is missing
     */
    public static MorrisEffects of(double[][] changes, double[] responses, Bootstrap bootstrap) {
        int factors = changes.length == 0 ? 0 : changes[0].length;
        List<List<Double>> effects = new ArrayList<>();
        for (int f = 0; f < factors; f++) {
            effects.add(new ArrayList<>());
        }
        for (int p = 1; p < changes.length; p++) {
            if (p % (factors + 1) != 0) {
                addEffect(changes[p], responses[p] - responses[p - 1], effects);
            }
        }
        List<Estimate> mu = new ArrayList<>();
        List<Estimate> muStar = new ArrayList<>();
        List<Estimate> sigma = new ArrayList<>();
        for (List<Double> of : effects) {
            mu.add(bootstrap.of(of.size(), chosen -> mean(of, chosen, false)));
            muStar.add(bootstrap.of(of.size(), chosen -> mean(of, chosen, true)));
            sigma.add(bootstrap.of(of.size(), chosen -> deviation(of, chosen)));
        }
        return new MorrisEffects(mu, muStar, sigma);
    }

    private static void addEffect(double[] steps, double change, List<List<Double>> effects) {
        for (int f = 0; f < effects.size(); f++) {
            if (steps[f] != 0 && Double.isFinite(change)) {
                effects.get(f).add(change / steps[f]);
            }
        }
    }

    private static double mean(List<Double> effects, int[] chosen, boolean absolute) {
        double sum = 0;
        for (int i : chosen) {
            sum += absolute ? Math.abs(effects.get(i)) : effects.get(i);
        }
        return sum / chosen.length;
    }

    private static double deviation(List<Double> effects, int[] chosen) {
        double mean = mean(effects, chosen, false);
        double sum = 0;
        for (int i : chosen) {
            sum += (effects.get(i) - mean) * (effects.get(i) - mean);
        }
        return chosen.length < 2 ? Double.NaN : Math.sqrt(sum / (chosen.length - 1));
    }
}
