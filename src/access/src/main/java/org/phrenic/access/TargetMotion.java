package org.phrenic.access;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.mesh.Vectors;

/**
 * Motion of a target during a breath.
 *
 * @param positions positions of the centre, LPS, mm; read-only
 */
public record TargetMotion(List<double[]> positions) {
    /** Excursion, mm: the largest distance between any two positions. */
    public double excursionMm() {
        return positions.stream()
                .flatMapToDouble(a -> positions.stream().mapToDouble(b -> Vectors.distance(a, b)))
                .max()
                .orElse(0);
    }

    /** Range of motion along x, y and z (left, posterior, superior), mm. */
    public double[] rangeMm() {
        return IntStream.range(0, 3).mapToDouble(this::range).toArray();
    }

    private double range(int axis) {
        DoubleSummaryStatistics all =
                positions.stream().mapToDouble(p -> p[axis]).summaryStatistics();
        return positions.isEmpty() ? 0 : all.getMax() - all.getMin();
    }
}
