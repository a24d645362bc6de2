package org.phrenic.study.error;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Non-dominated points: no other point has both lower cost and lower error. */
final class ParetoFront {
    private ParetoFront() {}

    /** Marks the points on the front. Of equal points only the first is marked; a point with NaN is never marked. */
    static boolean[] of(double[] cost, double[] error) {
        boolean[] front = new boolean[cost.length];
        List<Integer> order = IntStream.range(0, cost.length)
                .boxed()
                .sorted(Comparator.<Integer>comparingDouble(i -> cost[i]).thenComparingDouble(i -> error[i]))
                .toList();
        double best = Double.POSITIVE_INFINITY;
        for (int i : order) {
            if (error[i] < best && !Double.isNaN(cost[i])) {
                best = error[i];
                front[i] = true;
            }
        }
        return front;
    }
}
