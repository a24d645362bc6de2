package org.phrenic.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.fit.search.DistanceGradient;
import org.phrenic.fit.search.Evaluation;

/**
 * A body that breathes, how far it is from its targets, and which way leads nearer.
 *
 * <p>Used by one thread at a time.
 */
final class FitObjective implements AutoCloseable {
    /** What a body that came apart is worth, mm: worse than any that did not. */
    private static final double CAME_APART_MM = 1000;

    private final FitHalf half;
    private final InspiratoryHold breath;
    private final List<TargetDistance> distances;
    /** Those that count, where the part of each begins in a shape, and its share of the mean. */
    private final List<TargetDistance> counting = new ArrayList<>();

    private final int[] offsets;
    private final double[] weights;
    private final int length;
    private List<DistanceGradient> slopes = List.of();

    FitObjective(FitSetup setup) {
        half = setup.fittedHalf();
        breath = new InspiratoryHold(setup.base().with("threads=1"), setup.thorax(), setup.parameters());
        distances = setup.targets().stream()
                .map(t -> new TargetDistance(t, breath.surfaces()))
                .toList();
        distances.stream().filter(d -> d.target().weight() > 0).forEach(counting::add);
        offsets = new int[counting.size()];
        weights = new double[counting.size()];
        double all = counting.stream().mapToDouble(d -> d.target().weight()).sum();
        int next = 0;
        for (int i = 0; i < offsets.length; i++) {
            weights[i] = counting.get(i).target().weight() / all;
            offsets[i] = next;
            for (int j = 0; j < i && offsets[i] == next; j++) {
                if (counting.get(j).sharesSurfaces(counting.get(i))) {
                    offsets[i] = offsets[j];
                }
            }
            next += offsets[i] == next ? counting.get(i).length() : 0;
        }
        length = next;
    }

    InspiratoryHold breath() {
        return breath;
    }

    /** One a target, also of those held out. */
    List<TargetDistance> distances() {
        return distances;
    }

    /** Mean distance at rest of what is fitted to, by the targets' weights. */
    double initialMm() {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += weights[i] * counting.get(i).atRest(half).mean();
        }
        return sum;
    }

    /** Breathes in with these values of the parameters. */
    Evaluation evaluate(double[] values) {
        if (!breath.breatheIn(values)) {
            return new Evaluation(CAME_APART_MM, new float[0]);
        }
        float[] shape = new float[length];
        double mean = 0;
        for (int i = 0; i < offsets.length; i++) {
            double[] part = counting.get(i).positions(breath);
            mean += weights[i] * counting.get(i).mean(part, half);
            for (int k = 0; k < part.length; k++) {
                shape[offsets[i] + k] = (float) part[k];
            }
        }
        return new Evaluation(mean, shape);
    }

    /** Tells of every distance that counts of a shape, with places in the shape instead of vertices. */
    void visitDistances(double[] shape, DistanceGradient.Visitor told) {
        if (slopes.isEmpty()) {
            slopes = counting.stream().map(d -> d.gradient(half)).toList();
        }
        int[] places = new int[3];
        for (int i = 0; i < offsets.length; i++) {
            int offset = offsets[i];
            double share = weights[i];
            slopes.get(i)
                    .visit(
                            Arrays.copyOfRange(
                                    shape, offset, offset + counting.get(i).length()),
                            (weight, distance, direction, vertices, shares) -> {
                                for (int c = 0; c < 3; c++) {
                                    places[c] = offset + 3 * vertices[c];
                                }
                                told.accept(share * weight, distance, direction, places, shares);
                            });
        }
    }

    /** Whether {@link #visitDistances} can: not of pairs of points. */
    boolean hasGradient() {
        return counting.stream().noneMatch(d -> d.target().isPointPairs());
    }

    @Override
    public void close() {
        breath.close();
    }
}
