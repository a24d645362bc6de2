package org.phrenic.fit;

import java.util.Arrays;
import java.util.List;
import org.phrenic.fit.search.DistanceGradient;
import org.phrenic.fit.search.Evaluation;

/**
 * The objective of a fit: the weighted mean distance between a simulated body and its targets. It also provides the
 * gradient with respect to the vertex positions.
 *
 * <p>Must be used by one thread at a time.
 */
final class FitObjective implements AutoCloseable {
    private final FitHalf half;
    private final InspiratoryHold breath;
    private final List<TargetDistance> distances;
    /** Targets with a positive weight. For each: offset of its part in a shape, and share of the mean. */
    private final List<TargetDistance> weighted;

    private final int[] offsets;
    private final double[] weights;
    private final int length;
    private List<DistanceGradient> gradients = List.of();

    FitObjective(FitSetup setup) {
        half = setup.options().half();
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
            // Targets on the same surfaces share their positions in the shape.
            offsets[i] = part < i ? offsets[part] : next;
            next += part < i ? 0 : weighted.get(i).length();
        }
        length = next;
    }

    InspiratoryHold breath() {
        return breath;
    }

    /** Distances from all targets, including those that are not fitted. */
    List<TargetDistance> distances() {
        return distances;
    }

    /** Objective value of the body at rest, mm. */
    double initialMm() {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += weights[i] * weighted.get(i).atRest(half).mean();
        }
        return sum;
    }

    /** Simulates the breath with the given parameter values. */
    Evaluation evaluate(double[] values) {
        String failure = breath.breatheInForSearch(values);
        if (!failure.isEmpty()) {
            return Evaluation.failed(values, failure);
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

    /** Simulates a breath up to its observation; its objective value, mm, which is infinite if the breath fails. */
    double observedMm(double[] values) {
        return breath.breatheIn(values).isEmpty() ? currentMm() : Double.POSITIVE_INFINITY;
    }

    /** Objective value of the current state of the body, mm. */
    double currentMm() {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += weights[i] * weighted.get(i).mean(weighted.get(i).positions(breath), half);
        }
        return sum;
    }

    /** Objective value of a shape, mm. */
    double meanMm(double[] shape) {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            double[] part = Arrays.copyOfRange(
                    shape, offsets[i], offsets[i] + weighted.get(i).length());
            sum += weights[i] * weighted.get(i).mean(part, half);
        }
        return sum;
    }

    /** Visits every weighted distance of a shape. Vertices are given as indices into the shape. */
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

    /** Whether {@link #visitDistances} is supported, which is the case if no target consists of point pairs. */
    boolean hasGradient() {
        return weighted.stream().noneMatch(d -> d.target().isPointPairs());
    }

    @Override
    public void close() {
        breath.close();
    }
}
