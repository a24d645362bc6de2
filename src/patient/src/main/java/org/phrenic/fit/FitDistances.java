package org.phrenic.fit;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * Symmetric distances between a part of the body and its target, mm.
 *
 * @param model current mesh of the part; null for point pairs
 * @param toTarget distance from each vertex of the part to the target, or from each point to its target position
 * @param modelWeights area associated with each vertex of the part; 0 for excluded vertices
 * @param toModel distance from each vertex of the target to the part; empty for point pairs
 * @param targetWeights area associated with each vertex of the target; 0 for excluded vertices
 */
public record FitDistances(
        TriangleMesh model, double[] toTarget, double[] modelWeights, double[] toModel, double[] targetWeights) {

    /** Area-weighted mean distance over both directions. This is the objective of a fit. */
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

    /** Area-weighted statistics over both directions. */
    public DistanceSummary summary() {
        return DistanceSummary.of(joined(toTarget, toModel), joined(modelWeights, targetWeights));
    }

    private static double[] joined(double[] a, double[] b) {
        return DoubleStream.concat(Arrays.stream(a), Arrays.stream(b)).toArray();
    }
}
