package org.phrenic.fit;

import java.util.Arrays;
import java.util.List;
import org.phrenic.fit.search.DistanceGradient;
import org.phrenic.fit.search.Evaluation;

/**
 * The objective of a fit: the weighted mean distance of a simulated body from its targets, and its gradient by the
 * vertex positions.
 *
 * <p>Used by one thread at a time.
 */
final class FitObjective implements AutoCloseable {
    /** Value of a body whose simulation diverged, mm: larger than that of any other. */
    private static final double DIVERGED_MM = 1000;

    private final FitHalf half;
    private final InspiratoryHold breath;
    private final List<TargetDistance> distances;
    /** Targets with a weight; for each, where its part begins in a shape, and its share of the mean. */
    private final List<TargetDistance> weighted;

    private final int[] offsets;
    private final double[] weights;
    private final int length;
    private List<DistanceGradient> gradients = List.of();

    FitObjective(FitSetup setup) {
        half = setup.fittedHalf();
        breath = new InspiratoryHold(setup.base().with("threads=1"), setup.thorax(), setup.parameters());
        distances = setup.targets().stream()
                .map(t -> new TargetDistance(t, breath.surfaces()))
                .toList();
        weighted = distances.stream().filter(d -> d.target().weight() > 0).toList();
        double all = weighted.stream().mapToDouble(d -> d.target().weight()).sum();
        weights = weighted.stream().mapToDouble(d -> d.target().weight() / all).toArray();
        offsets = new int[weights.length];
        int next = 0;
        for (int i = 0; i < offsets.length; i++) {
            int part = 0;
            while (!weighted.get(part).sharesSurfaces(weighted.get(i))) {
                part++;
            }
            // Targets of the same surfaces share their positions in the shape.
            offsets[i] = part < i ? offsets[part] : next;
            next += part < i ? 0 : weighted.get(i).length();
        }
        length = next;
    }

    InspiratoryHold breath() {
        return breath;
    }

    /** The distance from each target, held out or not. */
    List<TargetDistance> distances() {
        return distances;
    }

    /** Value of the body at rest, mm. */
    double initialMm() {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += weights[i] * weighted.get(i).atRest(half).mean();
        }
        return sum;
    }

    /** Simulates the breath with these parameter values. */
    Evaluation evaluate(double[] values) {
        if (!breath.breatheIn(values)) {
            return new Evaluation(values, DIVERGED_MM);
        }
        float[] shape = new float[length];
        double mean = 0;
        for (int i = 0; i < offsets.length; i++) {
            double[] part = weighted.get(i).positions(breath);
            mean += weights[i] * weighted.get(i).mean(part, half);
            for (int k = 0; k < part.length; k++) {
                shape[offsets[i] + k] = (float) part[k];
            }
        }
        return new Evaluation(values, mean, shape);
    }

    /** Visits every weighted distance of a shape; vertices are given as positions in the shape. */
    void visitDistances(double[] shape, DistanceGradient.Visitor visitor) {
        if (gradients.isEmpty()) {
            gradients = weighted.stream().map(d -> d.gradient(half)).toList();
        }
        for (int i = 0; i < offsets.length; i++) {
            int offset = offsets[i];
            double share = weights[i];
            double[] part =
                    Arrays.copyOfRange(shape, offset, offset + weighted.get(i).length());
            gradients.get(i).visit(part, (weight, distance, direction, vertices, shares) -> {
                int[] places = {offset + 3 * vertices[0], offset + 3 * vertices[1], offset + 3 * vertices[2]};
                visitor.accept(share * weight, distance, direction, places, shares);
            });
        }
    }

    /** Whether {@link #visitDistances} is possible: no target is pairs of points. */
    boolean hasGradient() {
        return weighted.stream().noneMatch(d -> d.target().isPointPairs());
    }

    @Override
    public void close() {
        breath.close();
    }
}
