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
 * Covariance matrix adaptation (Hansen 2006, doi 10.1007/3-540-32494-1_4), the one of Commons Math, a generation at a
 * time.
 *
 * <p>That optimiser asks for one value after the other and cannot be stopped and gone on with. But what it asks for is
 * a function of its seed and of the values it was told, and within a generation it asks for all points before it looks
 * at any value. So it is run anew for every generation on the values known so far, until it has asked for one
 * generation more; those points are worked out in any order, on any number of threads, and kept. A search that was
 * killed goes on by the same way from what it kept. Path and result are those of the optimiser run alone.
 */
public final class CmaEsSearch {
    private final int dimension;
    private final int population;
    private final double[] sigma;
    private final long seed;
    private final double[] start;

    /** Works out points of one generation. */
    interface BatchEvaluator {
        /**
         * @param first number of the first of them
         * @return their values
         */
        double[] evaluate(int first, List<double[]> points);
    }

    /** Whether to begin another generation. */
    interface Continuation {
        boolean proceed(List<EvaluatedPoint> trials, int next);
    }

    /** Thrown out of the optimiser when a generation is complete. */
    private static final class GenerationCompleteException extends RuntimeException {
        private static final long serialVersionUID = 1;

        GenerationCompleteException() {
            super("generation complete", null, false, false);
        }
    }

    /**
     * A search in the unit cube.
     *
     * @param start where it begins, each from 0 to 1
     * @param population points a generation
     * @param sigma standard deviation of the first generation along each axis
     */
    CmaEsSearch(double[] start, int population, double[] sigma, long seed) {
        this.start = start.clone();
        dimension = start.length;
        this.population = population;
        this.sigma = sigma.clone();
        this.seed = seed;
    }

    /** Points a generation that the method takes by itself for so many dimensions: 4 + 3 ln n. */
    public static int defaultPopulation(int dimension) {
        return 4 + (int) (3 * StrictMath.log(dimension));
    }

    /**
     * Searches.
     *
     * @param going asked before every generation
     * @return all that was tried, in order: the start, then generation after generation
     */
    List<EvaluatedPoint> run(BatchEvaluator work, Continuation going) {
        List<EvaluatedPoint> trials = new ArrayList<>();
        while (true) {
            List<double[]> asked = next(trials);
            if (asked.isEmpty() || !going.proceed(trials, asked.size())) {
                return trials;
            }
            double[] values = work.evaluate(trials.size(), asked);
            for (int i = 0; i < values.length; i++) {
                trials.add(new EvaluatedPoint(asked.get(i), values[i]));
            }
        }
    }

    /** The points of the generation after the trials; none if the optimiser has converged. */
    private List<double[]> next(List<EvaluatedPoint> trials) {
        List<double[]> asked = new ArrayList<>();
        int size = trials.isEmpty() ? 1 : population;
        int[] count = {0};
        try {
            optimiser()
                    .optimize(
                            new MaxEval(Integer.MAX_VALUE),
                            new ObjectiveFunction(point -> {
                                int number = count[0]++;
                                if (number < trials.size()) {
                                    EvaluatedPoint known = trials.get(number);
                                    if (!Arrays.equals(known.point(), point)) {
                                        throw new IllegalStateException(
                                                "the search asks for other points than it did, expected the same");
                                    }
                                    return known.value();
                                }
                                asked.add(point.clone());
                                if (asked.size() == size) {
                                    throw new GenerationCompleteException();
                                }
                                return 0;
                            }),
                            GoalType.MINIMIZE,
                            new SimpleBounds(new double[dimension], filled(1)),
                            new InitialGuess(start),
                            new CMAESOptimizer.Sigma(sigma),
                            new CMAESOptimizer.PopulationSize(population));
        } catch (GenerationCompleteException complete) {
            return asked;
        }
        return List.of();
    }

    private double[] filled(double value) {
        double[] all = new double[dimension];
        Arrays.fill(all, value);
        return all;
    }

    private CMAESOptimizer optimiser() {
        return new CMAESOptimizer(Integer.MAX_VALUE, 0, true, 0, 0, new MersenneTwister(seed), false, null);
    }
}
