package org.phrenic.fit;

import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Hashes;
import org.phrenic.fit.search.CmaEsSearch;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.SearchSpace;
import org.phrenic.scenario.Scenario;

/**
 * What is to be fitted to what, and how.
 *
 * @param base body, resolution and all that is not tuned
 * @param thorax the body at end-expiration, already at hand
 * @param targets where it is at the second breath level; at least one with a weight
 * @param parameters what is tuned
 * @param holdOutHalf whether only one half of every surface is fitted to, and the other reported on
 * @param alignment how the axes of the targets were brought to those of the body, in a sentence
 * @param seed of the search
 * @param population points a generation; 0 for 4 + 3 ln n
 * @param sigma standard deviation of the first generation as a share of the bounds
 * @param threads bodies that are breathed side by side; the result does not depend on it
 * @param maxEvaluations bound on the evaluations of the search
 * @param budgetS no generation is begun after so many seconds; infinite for no such bound
 * @param sensitivity whether each parameter is moved to both sides in the end, two evaluations each
 */
public record FitSetup(
        Scenario base,
        Thorax thorax,
        List<FitTarget> targets,
        List<FitParameter> parameters,
        boolean holdOutHalf,
        String alignment,
        long seed,
        int population,
        double sigma,
        int threads,
        int maxEvaluations,
        double budgetS,
        boolean sensitivity) {
    /** Standard deviation of the first generation where nothing else is said. */
    public static final double SIGMA = 0.2;

    public FitSetup {
        targets = List.copyOf(targets);
        parameters = List.copyOf(parameters);
        if (targets.stream().noneMatch(t -> t.weight() > 0)) {
            throw new IllegalArgumentException("fit: found no target with a weight, expected one to fit to");
        }
        if (parameters.isEmpty()) {
            throw new IllegalArgumentException("fit: found no parameter, expected one to tune");
        }
    }

    /** As usual: seed 1, the usual population, one thread, as many evaluations as asked for. */
    public static FitSetup of(
            Scenario base, Thorax thorax, List<FitTarget> targets, List<FitParameter> parameters, int maxEvaluations) {
        return new FitSetup(
                base,
                thorax,
                targets,
                parameters,
                false,
                "none: the targets are taken to be in the axes of the body",
                1,
                0,
                SIGMA,
                1,
                maxEvaluations,
                Double.POSITIVE_INFINITY,
                true);
    }

    /** The same on so many threads. */
    public FitSetup onThreads(int count) {
        return new FitSetup(
                base,
                thorax,
                targets,
                parameters,
                holdOutHalf,
                alignment,
                seed,
                population,
                sigma,
                count,
                maxEvaluations,
                budgetS,
                sensitivity);
    }

    /** Points a generation. */
    int populationSize() {
        return population > 0 ? population : CmaEsSearch.defaultPopulation(parameters.size());
    }

    /** Values of the parameters at a place of the unit cube. */
    double[] parameters(double[] unit) {
        return new SearchSpace(parameters).values(unit);
    }

    /** Which half of the surfaces is fitted to. */
    FitHalf fittedHalf() {
        return holdOutHalf ? FitHalf.FITTED : FitHalf.ALL;
    }

    /**
     * Hash of all that the values of the search depend on: two fits with one mark ask for the same points and get the
     * same values.
     */
    String fingerprint() {
        StringBuilder text = new StringBuilder();
        base.toMap().forEach((key, value) -> {
            if (!key.equals("threads") && !key.equals("name")) {
                text.append(key).append('=').append(value).append('\n');
            }
        });
        parameters.forEach(
                p -> text.append(p).append(' ').append(p.relativeSigma()).append('\n'));
        text.append(holdOutHalf)
                .append(' ')
                .append(seed)
                .append(' ')
                .append(populationSize())
                .append(' ')
                .append(sigma)
                .append(" descent of an even sheet");
        double[][] arrays =
                new double[1 + 3 * targets.size() + thorax.structures().size()][];
        int next = 0;
        for (FitTarget target : targets) {
            text.append('\n')
                    .append(target.name())
                    .append(' ')
                    .append(target.part())
                    .append(' ')
                    .append(target.weight());
            arrays[next++] = target.from();
            arrays[next++] = target.to();
            arrays[next++] =
                    target.isPointPairs() ? new double[0] : target.surface().positions();
        }
        for (var structure : thorax.structures()) {
            arrays[next++] = structure.mesh().positions();
        }
        arrays[next] = text.chars().asDoubleStream().toArray();
        return Hashes.sha256(arrays).substring(0, 12);
    }
}
