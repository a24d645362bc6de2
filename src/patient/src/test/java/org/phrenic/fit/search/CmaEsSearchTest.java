package org.phrenic.fit.search;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.junit.jupiter.api.Test;

/** A generation at a time goes the way of the optimiser that is asked for one value after the other. */
class CmaEsSearchTest {
    private static final int POPULATION = 8;
    private static final double SIGMA = 0.3;
    private static final long SEED = 7;

    /** Rosenbrock's valley in the unit cube, its minimum at 0.75 each. */
    private static double rosenbrock(double[] u) {
        double sum = 0;
        for (int i = 0; i + 1 < u.length; i++) {
            double x = 4 * u[i] - 2;
            double y = 4 * u[i + 1] - 2;
            sum += 100 * (y - x * x) * (y - x * x) + (1 - x) * (1 - x);
        }
        return sum;
    }

    private static double[] filled(int n, double value) {
        double[] all = new double[n];
        Arrays.fill(all, value);
        return all;
    }

    /** What the optimiser alone asks for, in its order. */
    private static List<double[]> alone(int n, int evaluations) {
        List<double[]> asked = new ArrayList<>();
        CMAESOptimizer plain =
                new CMAESOptimizer(Integer.MAX_VALUE, 0, true, 0, 0, new MersenneTwister(SEED), false, null);
        try {
            plain.optimize(
                    new MaxEval(evaluations),
                    new ObjectiveFunction(p -> {
                        asked.add(p.clone());
                        return rosenbrock(p);
                    }),
                    GoalType.MINIMIZE,
                    new SimpleBounds(filled(n, 0), filled(n, 1)),
                    new InitialGuess(filled(n, 0.4)),
                    new CMAESOptimizer.Sigma(filled(n, SIGMA)),
                    new CMAESOptimizer.PopulationSize(POPULATION));
        } catch (org.apache.commons.math3.exception.TooManyEvaluationsException end) {
            return asked;
        }
        return asked;
    }

    private static List<Evaluation> evaluateBackwards(List<double[]> points) {
        Evaluation[] batch = new Evaluation[points.size()];
        for (int i = points.size() - 1; i >= 0; i--) {
            batch[i] = new Evaluation(points.get(i), rosenbrock(points.get(i)));
        }
        return List.of(batch);
    }

    private static List<Evaluation> search(int n, int evaluations) {
        return new CmaEsSearch(filled(n, 0.4), POPULATION, filled(n, SIGMA), SEED)
                .run((first, points) -> first + points.size() > evaluations ? List.of() : evaluateBackwards(points));
    }

    @Test
    void asksForThePointsOfTheOptimiserBitByBit() {
        for (int n : new int[] {2, 5}) {
            int evaluations = 1 + 40 * POPULATION;
            List<double[]> alone = alone(n, evaluations);
            List<Evaluation> trials = search(n, evaluations);
            assertThat(trials).hasSize(evaluations);
            for (int i = 0; i < evaluations; i++) {
                assertThat(trials.get(i).point()).containsExactly(alone.get(i));
            }
        }
    }

    @Test
    void findsTheMinimumWithinTheBoundsAndStopsThere() {
        List<Evaluation> trials = search(2, 5000);
        Evaluation best = trials.stream()
                .min(java.util.Comparator.comparingDouble(Evaluation::value))
                .orElseThrow();
        assertThat(trials.size()).isLessThan(2000);
        assertThat(best.point()[0]).isCloseTo(0.75, org.assertj.core.data.Offset.offset(1e-4));
        assertThat(trials).allMatch(t -> Arrays.stream(t.point()).allMatch(u -> u >= 0 && u <= 1));
    }
}
