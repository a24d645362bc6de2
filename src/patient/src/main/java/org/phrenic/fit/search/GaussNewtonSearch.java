package org.phrenic.fit.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Goes down to where a body lies on its targets by what each parameter does to every vertex: a Gauss-Newton search in a
 * trust region, for the mean distance itself (iteratively reweighted least squares). One breath a parameter gives the
 * changes of the shape ({@link LinearShapeModel}); on that linear body the way down is looked for without breathing
 * ({@code ReweightedGaussNewton}), with several reaches; the places found are breathed side by side, and the linear
 * body learns from each. Where that gains nothing any more the changes are measured anew, to the other side.
 *
 * <p>Asks for one batch after the other, each a function of what came of those before.
 */
public final class GaussNewtonSearch {
    /**
     * Step of a parameter to see what it does: a share of the cube that moves the shape by more than what is uneven in
     * it.
     */
    private static final double MEASURING_STEP = 0.08;

    private static final double FIRST_REACH = 0.3;
    private static final double LARGEST_REACH = 0.6;
    private static final double LEAST_REACH = 0.01;
    /** Share of the reach and damping of each place of a batch. */
    private static final double[][] TRIES = {{1, 1e-3}, {1, 3e-2}, {0.5, 1e-3}, {0.25, 1e-2}};

    private static final double WIDER = 1.5;
    private static final double NARROWER = 0.3;
    /** A round that gains less than this share gains nothing; so many of them are enough. */
    private static final double GAIN = 0.01;

    private static final int PATIENCE = 1;
    private static final int MOST_MEASUREMENTS = 5;

    /** Works out a batch. */
    interface BatchEvaluator {
        /**
         * @param first number of the first of them
         * @return none if the search is to end here
         */
        List<Evaluation> evaluate(int first, List<double[]> points);
    }

    /** Looks for ways down on a linear body, one for each share of a reach and damping. */
    public interface SubproblemSolver {
        List<double[]> candidates(LinearShapeModel body, double reach, double[][] tries);
    }

    private final BatchEvaluator work;
    private final SubproblemSolver down;
    private final List<EvaluatedPoint> trials = new ArrayList<>();
    private final LinearShapeModel body;
    private final int dimension;
    private double[] best;
    private Evaluation bestOutcome;

    GaussNewtonSearch(int dimension, BatchEvaluator work, SubproblemSolver down) {
        this.dimension = dimension;
        this.work = work;
        this.down = down;
        body = new LinearShapeModel(dimension);
    }

    /**
     * Searches.
     *
     * @return all that was tried, in order; the start alone if it has no shape
     */
    List<EvaluatedPoint> run(double[] start) {
        List<Evaluation> first = evaluate(List.of(start));
        if (first.isEmpty() || !first.get(0).hasShape()) {
            return trials;
        }
        best = start.clone();
        bestOutcome = first.get(0);
        double reach = FIRST_REACH;
        for (int measurement = 0; measurement < MOST_MEASUREMENTS; measurement++) {
            double before = bestOutcome.value();
            if (!finiteDifferences(measurement)) {
                return trials;
            }
            reach = iterate(Math.max(reach, FIRST_REACH / (1 << measurement)));
            if (reach < 0 || before - bestOutcome.value() < GAIN * before) {
                return trials;
            }
        }
        return trials;
    }

    /**
     * Moves each parameter alone; to the side where there is more room, every second time to the other if there is
     * room.
     */
    private boolean finiteDifferences(int time) {
        body.recentre(best, bestOutcome.shape());
        List<double[]> points = new ArrayList<>();
        double[] ways = new double[dimension];
        for (int k = 0; k < dimension; k++) {
            double room = best[k] < 0.5 ? 1 : -1;
            boolean other = time % 2 == 1 && best[k] >= MEASURING_STEP && best[k] <= 1 - MEASURING_STEP;
            ways[k] = (other ? -room : room) * MEASURING_STEP;
            double[] moved = best.clone();
            moved[k] += ways[k];
            points.add(moved);
        }
        List<Evaluation> outcomes = evaluate(points);
        for (int k = 0; k < outcomes.size(); k++) {
            if (outcomes.get(k).hasShape()) {
                body.setFiniteDifference(k, ways[k], outcomes.get(k).shape());
            }
        }
        update(points, outcomes, false);
        return !outcomes.isEmpty();
    }

    /** Goes down round by round; the reach it ended with, -1 if the search is to end. */
    private double iterate(double from) {
        double reach = from;
        int idle = 0;
        while (idle < PATIENCE && reach > LEAST_REACH) {
            double before = bestOutcome.value();
            List<double[]> points = down.candidates(body, reach, TRIES);
            List<Evaluation> outcomes = evaluate(points);
            if (outcomes.isEmpty()) {
                return -1;
            }
            int winner = update(points, outcomes, true);
            if (winner < 0) {
                reach *= NARROWER;
            } else {
                reach = Math.min(LARGEST_REACH, reach * TRIES[winner][0] * WIDER);
            }
            idle = before - bestOutcome.value() < GAIN * before ? idle + 1 : 0;
        }
        return reach;
    }

    /** Learns from a batch, and goes to its best place if that is better than any before. */
    private int update(List<double[]> points, List<Evaluation> outcomes, boolean learn) {
        for (int i = 0; learn && i < outcomes.size(); i++) {
            if (outcomes.get(i).hasShape()) {
                body.broydenUpdate(points.get(i), outcomes.get(i).shape());
            }
        }
        int winner = IntStream.range(0, outcomes.size())
                .boxed()
                .min(Comparator.comparingDouble(i -> outcomes.get(i).value()))
                .orElse(-1);
        if (winner < 0 || !(outcomes.get(winner).value() < bestOutcome.value())) {
            return -1;
        }
        best = points.get(winner).clone();
        bestOutcome = outcomes.get(winner);
        body.recentre(best, bestOutcome.shape());
        return winner;
    }

    private List<Evaluation> evaluate(List<double[]> points) {
        List<Evaluation> outcomes = work.evaluate(trials.size(), points);
        for (int i = 0; i < outcomes.size(); i++) {
            trials.add(new EvaluatedPoint(points.get(i), outcomes.get(i).value()));
        }
        return outcomes;
    }
}
