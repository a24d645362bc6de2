package org.phrenic.fit;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * Distances of a part of the body from its target, both ways, mm.
 *
 * @param model the part as it stands; null for pairs of points
 * @param toTarget distance of each vertex of the part from the target, or of each point from where it should be
 * @param modelWeights area about each vertex, 0 where it does not count
 * @param toModel distance of each vertex of the target from the part; empty for pairs of points
 * @param targetWeights area about each vertex of the target, 0 where it does not count
 */
public record FitDistances(
        TriangleMesh model, double[] toTarget, double[] modelWeights, double[] toModel, double[] targetWeights) {

    /** Mean of both directions by area: what a fit makes small. */
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

    /** Figures of both directions by area. */
    public DistanceSummary summary() {
        double[] distances = new double[toTarget.length + toModel.length];
        double[] weights = new double[distances.length];
        System.arraycopy(toTarget, 0, distances, 0, toTarget.length);
        System.arraycopy(toModel, 0, distances, toTarget.length, toModel.length);
        System.arraycopy(modelWeights, 0, weights, 0, toTarget.length);
        System.arraycopy(targetWeights, 0, weights, toTarget.length, toModel.length);
        return DistanceSummary.of(distances, weights);
    }
}
