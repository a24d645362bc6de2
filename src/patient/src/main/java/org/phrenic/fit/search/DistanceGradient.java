package org.phrenic.fit.search;

import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * How the mean distance of a part from its target changes as the part moves: every distance that counts, the direction
 * in which it grows, and the vertices of the part that move it. Of large targets every so many vertices stand for all.
 *
 * <p>Used by one thread.
 */
public final class DistanceGradient {
    /** So many vertices of a target are enough to say where to go. */
    private static final int MOST_POINTS = 800;

    /** Told of one distance. */
    public interface Visitor {
        /**
         * @param weight its share of the mean, all together 1
         * @param distance mm
         * @param direction unit vector in which the part's point moves away
         * @param vertices three of the part
         * @param shares how much the point goes with each of them
         */
        void accept(double weight, double distance, double[] direction, int[] vertices, double[] shares);
    }

    private final TriangleMesh rest;
    private final TriangleMesh target;
    private final TriangleTree fromModel;
    private final TriangleTree fromTarget;
    private final double[] modelWeights;
    private final int[] points;
    private final double[] pointWeights;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final double[] direction = new double[3];
    private final double[] shares = new double[3];
    private final int[] vertices = new int[3];

    /**
     * @param rest the part
     * @param modelCounts 1 for each vertex of the part that counts, else 0
     * @param target where it should be
     * @param targetWeights area about each vertex of the target, 0 where it does not count
     */
    public DistanceGradient(TriangleMesh rest, double[] modelCounts, TriangleMesh target, double[] targetWeights) {
        this.rest = rest;
        this.target = target;
        fromModel = new TriangleTree(rest);
        fromTarget = new TriangleTree(target);
        modelWeights = modelCounts.clone();
        double[] areas = MeshMeasure.vertexAreas(rest);
        double sum = 0;
        for (int v = 0; v < areas.length; v++) {
            modelWeights[v] *= areas[v];
            sum += modelWeights[v];
        }
        int counting = 0;
        double targetArea = 0;
        for (double weight : targetWeights) {
            counting += weight > 0 ? 1 : 0;
            targetArea += weight;
        }
        int stride = 1 + counting / MOST_POINTS;
        points = new int[(counting + stride - 1) / stride];
        pointWeights = new double[points.length];
        double taken = 0;
        int seen = 0;
        for (int v = 0; v < targetWeights.length; v++) {
            if (targetWeights[v] > 0 && seen++ % stride == 0) {
                int i = (seen - 1) / stride;
                points[i] = v;
                pointWeights[i] = targetWeights[v];
                taken += targetWeights[v];
            }
        }
        double all = sum + targetArea;
        for (int v = 0; v < modelWeights.length; v++) {
            modelWeights[v] /= all;
        }
        for (int i = 0; i < points.length; i++) {
            pointWeights[i] *= targetArea / taken / all;
        }
    }

    /** Tells of all distances of the part where it stands. */
    public void visit(double[] positions, Visitor told) {
        fromModel.refit(positions);
        for (int v = 0; v < modelWeights.length; v++) {
            if (modelWeights[v] > 0) {
                double x = positions[3 * v];
                double y = positions[3 * v + 1];
                double z = positions[3 * v + 2];
                fromTarget.closest(x, y, z, hit);
                vertices[0] = v;
                vertices[1] = v;
                vertices[2] = v;
                shares[0] = 1;
                shares[1] = 0;
                shares[2] = 0;
                visit(modelWeights[v], x - hit.x, y - hit.y, z - hit.z, told);
            }
        }
        int[] corners = rest.triangles();
        for (int i = 0; i < points.length; i++) {
            int p = points[i];
            fromModel.closest(target.x(p), target.y(p), target.z(p), hit);
            for (int c = 0; c < 3; c++) {
                vertices[c] = corners[3 * hit.triangle + c];
            }
            shares[0] = hit.weightA;
            shares[1] = hit.weightB;
            shares[2] = hit.weightC;
            visit(pointWeights[i], hit.x - target.x(p), hit.y - target.y(p), hit.z - target.z(p), told);
        }
    }

    private void visit(double weight, double dx, double dy, double dz, Visitor told) {
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (length > 0) {
            direction[0] = dx / length;
            direction[1] = dy / length;
            direction[2] = dz / length;
            told.accept(weight, length, direction, vertices, shares);
        }
    }
}
