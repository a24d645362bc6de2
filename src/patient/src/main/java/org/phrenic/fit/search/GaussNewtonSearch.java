package org.phrenic.fit.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Gauss-Newton search with a trust region for the smallest mean distance (iteratively reweighted least squares). Finite
 * differences, with one evaluation per parameter, give the {@link LinearShapeModel}. The subproblem on that model is
 * solved for several trust regions and dampings. The solutions are evaluated as one batch, and each evaluation updates
 * the model. If a round improves the objective too little, the finite differences are repeated in the opposite
 * direction.
 *
 * <p>Each batch depends only on the results of earlier batches.
 */
public final class GaussNewtonSearch {
    /** Finite difference step in the unit cube. It is large enough to change the shape by more than its roughness. */
    private static final double DIFFERENCE_STEP = 0.08;

    private static final double INITIAL_RADIUS = 0.3;
    private static final double MAX_RADIUS = 0.6;
    private static final double MIN_RADIUS = 0.01;

    /** Points of a batch, each given by a fraction of the trust region radius and a damping. */
    private static final double[][] TRIES = {{1, 1e-3}, {1, 3e-2}, {0.5, 1e-3}, {0.25, 1e-2}};

    private static final double RADIUS_GROWTH = 1.5;
    private static final double RADIUS_SHRINKAGE = 0.3;

    /** Minimum relative improvement of a round; smaller improvements end the round. */
    private static final double MIN_GAIN = 0.01;

    private static final int MAX_LINEARISATIONS = 5;

    /** Solves the trust-region subproblem on a linear model. */
    public interface SubproblemSolver {
        /** Returns one point for each pair of radius fraction and damping. */
        List<double[]> candidates(LinearShapeModel model, double radius, double[][] tries);
    }

    private final BatchEvaluator evaluator;
    private final SubproblemSolver solver;
    private final List<Evaluation> trials = new ArrayList<>();
    private final LinearShapeModel model;
    private final int dimension;
    private Evaluation best;
    private boolean isLinearised;

    GaussNewtonSearch(int dimension, BatchEvaluator evaluator, SubproblemSolver solver) {
        this.dimension = dimension;
        this.evaluator = evaluator;
        this.solver = solver;
        model = new LinearShapeModel(dimension);
    }

    /** Runs the search from one point. */
    List<Evaluation> run(double[] start) {
        return run(start, List.of(), Double.POSITIVE_INFINITY);
    }

    /**
     * Runs the search. Returns all evaluations in order, without shapes, or only the start if it has no shape.
     *
     * @param others further points to start from, which are evaluated if the value at the start exceeds a limit; the
     *     search then starts from the best
     */
    List<Evaluation> run(double[] start, List<double[]> others, double limit) {
        List<Evaluation> first = evaluate(List.of(start));
        if (first.isEmpty() || !first.get(0).hasShape()) {
            return trials;
        }
        best = first.get(0);
        if (best.value() > limit) {
            evaluate(others).stream()
                    .filter(e -> e.hasShape() && e.value() < best.value())
                    .forEach(e -> best = e);
        }
        double radius = INITIAL_RADIUS;
        for (int round = 0; round < MAX_LINEARISATIONS; round++) {
            double before = best.value();
            if (!finiteDifferences(round)) {
                return trials;
            }
            radius = iterate(Math.max(radius, INITIAL_RADIUS / (1 << round)));
            if (radius < 0 || isIdle(before)) {
                return trials;
            }
        }
        return trials;
    }

    /** The linear model at the end of the search; null if it has no derivatives. */
    LinearShapeModel model() {
        return isLinearised ? model : null;
    }

    private boolean isIdle(double before) {
        return before - best.value() < MIN_GAIN * before;
    }

    /**
     * Moves each parameter alone toward the more distant bound. Odd rounds use the opposite direction if there is room.
     */
    private boolean finiteDifferences(int round) {
        model.recentre(best.point(), best.shape());
        List<double[]> points = new ArrayList<>();
        double[] steps = new double[dimension];
        for (int k = 0; k < dimension; k++) {
            double u = best.point()[k];
            double room = u < 0.5 ? 1 : -1;
            boolean opposite = round % 2 == 1 && u >= DIFFERENCE_STEP && u <= 1 - DIFFERENCE_STEP;
            steps[k] = (opposite ? -room : room) * DIFFERENCE_STEP;
            double[] moved = best.point().clone();
            moved[k] += steps[k];
            points.add(moved);
        }
        List<Evaluation> batch = evaluate(points);
        for (int k = 0; k < batch.size(); k++) {
            Evaluation e = batch.get(k);
            if (e.hasShape() && e.hasFailed()) {
                model.broydenUpdate(e.point(), e.shape());
            } else if (e.hasShape()) {
                model.setFiniteDifference(k, steps[k], e.shape());
            }
        }
        isLinearised |= !batch.isEmpty();
        accept(batch);
        return !batch.isEmpty();
    }

    /** Descends batch by batch. Returns the final radius, or -1 to end the search. */
    private double iterate(double initialRadius) {
        double radius = initialRadius;
        while (radius > MIN_RADIUS) {
            double before = best.value();
            List<Evaluation> batch = evaluate(solver.candidates(model, radius, TRIES));
            if (batch.isEmpty()) {
                return -1;
            }
            batch.stream().filter(Evaluation::hasShape).forEach(e -> model.broydenUpdate(e.point(), e.shape()));
            int winner = accept(batch);
            radius = winner < 0
                    ? radius * RADIUS_SHRINKAGE
                    : Math.min(MAX_RADIUS, radius * TRIES[winner][0] * RADIUS_GROWTH);
            if (isIdle(before)) {
                return radius;
            }
        }
        return radius;
    }

    /** Recentres the model at the best point of a batch if it is the best so far. Returns its index, or -1. */
    private int accept(List<Evaluation> batch) {
        int winner = IntStream.range(0, batch.size())
                .boxed()
                .min(Comparator.comparingDouble(i -> batch.get(i).value()))
                .orElse(-1);
        if (winner < 0 || !(batch.get(winner).value() < best.value())) {
            return -1;
        }
        best = batch.get(winner);
        model.recentre(best.point(), best.shape());
        return winner;
    }

    private List<Evaluation> evaluate(List<double[]> points) {
        List<Evaluation> batch = evaluator.evaluate(trials.size(), points);
        batch.forEach(e -> trials.add(e.withoutShape()));
        return batch;
    }
}
