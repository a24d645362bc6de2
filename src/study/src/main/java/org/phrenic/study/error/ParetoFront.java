package org.phrenic.study.error;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Which of several things to choose from no other beats in both of two numbers that are to be small. */
final class ParetoFront {
    private ParetoFront() {}

    /** For each whether it is on the front; of two that are alike the first. A number that is none is never on it. */
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
