package org.phrenic.fit.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.optim.InitialGuess;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.SimpleBounds;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.nonlinear.scalar.ObjectiveFunction;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.apache.commons.math3.random.MersenneTwister;

/**
 * Covariance matrix adaptation evolution strategy (CMA-ES; Hansen 2006, doi 10.1007/3-540-32494-1_4). It runs the
 * implementation of Commons Math one generation at a time.
 *
 * <p>The optimiser of Commons Math requests one value at a time, but its points depend only on the seed and on the
 * values of earlier generations. To find the next generation, the optimiser is rerun on the known values with a budget
 * of one more generation. The points of that generation can then be evaluated in parallel, and an interrupted search
 * can resume from its known values. Path and result are identical to a single run of the optimiser.
 */
public final class CmaEsSearch {
    private final double[] start;
    private final int population;
    private final double[] sigma;
    private final long seed;

    /**
     * Creates a search in the unit cube.
     *
     * @param start initial mean, each coordinate from 0 to 1
     * @param population points per generation
     * @param sigma standard deviation of the first generation along each axis
     */
    CmaEsSearch(double[] start, int population, double[] sigma, long seed) {
        this.start = start.clone();
        this.population = population;
        this.sigma = sigma.clone();
        this.seed = seed;
    }

    /** Default population size for n dimensions, 4 + 3 ln n. */
    public static int defaultPopulation(int dimension) {
        return 4 + (int) (3 * StrictMath.log(dimension));
    }

    /** Runs the search. Returns all evaluations in order: the start, then each generation. */
    List<Evaluation> run(BatchEvaluator evaluator) {
        List<Evaluation> known = new ArrayList<>();
        while (true) {
            List<double[]> points = nextGeneration(known);
            List<Evaluation> batch = points.isEmpty() ? List.of() : evaluator.evaluate(known.size(), points);
            if (batch.isEmpty()) {
                return known;
            }
            for (int i = 0; i < batch.size(); i++) {
                Evaluation e = batch.get(i);
                // A breath that only succeeds with less drive tells nothing good about the requested point.
                known.add(new Evaluation(points.get(i), e.hasFailed() ? Evaluation.FAILED_MM : e.value()));
            }
        }
    }

    /** Points of the next generation, given the known evaluations; empty if the optimiser has converged. */
    private List<double[]> nextGeneration(List<Evaluation> known) {
        int size = known.isEmpty() ? 1 : population;
        List<double[]> points = new ArrayList<>();
        int[] count = {0};
        double[] upper = new double[start.length];
        Arrays.fill(upper, 1);
        new CMAESOptimizer(Integer.MAX_VALUE, 0, true, 0, 0, new MersenneTwister(seed), false, null)
                .optimize(
                        // The optimiser returns when the evaluation budget is exhausted.
                        new MaxEval(known.size() + size),
                        new ObjectiveFunction(point -> {
                            int number = count[0]++;
                            if (number >= known.size()) {
                                points.add(point.clone());
                                return 0;
                            }
                            if (!Arrays.equals(known.get(number).point(), point)) {
                                throw new IllegalStateException(
                                        "the optimiser repeats a search with other points, expected the same");
                            }
                            return known.get(number).value();
                        }),
                        GoalType.MINIMIZE,
                        new SimpleBounds(new double[start.length], upper),
                        new InitialGuess(start),
                        new CMAESOptimizer.Sigma(sigma),
                        new CMAESOptimizer.PopulationSize(population));
        return points;
    }
}
