package org.phrenic.fit.search;

import java.util.List;

/** Evaluates batches of points of the unit cube. The points of a batch may be evaluated in any order or in parallel. */
interface BatchEvaluator {
    /**
     * Evaluates a batch of points.
     *
     * @param first number of the first point, counted over all batches of a search
     * @return one evaluation per point, in order; empty to end the search
     */
    List<Evaluation> evaluate(int first, List<double[]> points);
}
