package org.phrenic.fit.search;

import java.util.List;

/** Evaluates a batch of points of the unit cube, in any order or in parallel. */
interface BatchEvaluator {
    /**
     * The evaluations in the order of the points.
     *
     * @param first number of the first point, counted over all batches of a search
     * @return none to end the search
     */
    List<Evaluation> evaluate(int first, List<double[]> points);
}
