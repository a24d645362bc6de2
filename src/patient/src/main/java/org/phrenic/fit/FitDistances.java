package org.phrenic.fit;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * Symmetric distances between a part of the body and its target, mm.
 *
 * @param model the part in its current position; null for pairs of points
 * @param toTarget distance of each vertex of the part from the target, or of each point from where it should be
 * @param modelWeights area about each vertex, 0 where it does not count
 * @param toModel distance of each vertex of the target from the part; empty for pairs of points
 * @param targetWeights area about each vertex of the target, 0 where it does not count
 */
public record FitDistances(
        TriangleMesh model, double[] toTarget, double[] modelWeights, double[] toModel, double[] targetWeights) {

    /** Mean of both directions by area: the objective of a fit. */
    public double mean() {
        double sum = 0;
        double total = 0;
        for (int i = 0; i < toTarget.length; i++) {
            sum += modelWeights[i] * toTarget[i];
            total += modelWeights[i];
        }
        for (int i = 0; i < toModel.length; i++) {
            sum += targetWeights[i] * toModel[i];
            total += targetWeights[i];
        }
        return total > 0 ? sum / total : 0;
    }

    /** Statistics of both directions by area. */
    public DistanceSummary summary() {
        return DistanceSummary.of(joined(toTarget, toModel), joined(modelWeights, targetWeights));
    }

    private static double[] joined(double[] a, double[] b) {
        return DoubleStream.concat(Arrays.stream(a), Arrays.stream(b)).toArray();
    }
}
