package org.phrenic.fit.search;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Gradient of the mean symmetric distance between a part of the body and its target. It consists of each weighted
 * distance, the direction in which the distance increases, and the vertices that affect it. At most
 * {@value #MAX_POINTS} target vertices, evenly spaced by index, represent the whole target.
 *
 * <p>Not thread-safe.
 */
public final class DistanceGradient {
    private static final int MAX_POINTS = 800;

    /** Receives distances one at a time. */
    public interface Visitor {
        /**
         * Receives one distance. The arrays are only valid during the call.
         *
         * @param weight weight in the mean; all weights sum to 1
         * @param distance distance, mm
         * @param direction unit vector; the distance increases if the point of the part moves along it
         * @param vertices three vertices of the part
         * @param shares barycentric weight of each vertex in the point
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

    /**
     * @param rest mesh of the part at rest
     * @param modelCounts 1 for each vertex of the part that is included, 0 otherwise
     * @param target target position of the part
     * @param targetWeights area associated with each vertex of the target; 0 for excluded vertices
     */
    public DistanceGradient(TriangleMesh rest, double[] modelCounts, TriangleMesh target, double[] targetWeights) {
        this.rest = rest;
        this.target = target;
        fromModel = new TriangleTree(rest);
        fromTarget = new TriangleTree(target);
        modelWeights = MeshMeasure.vertexAreas(rest);
        Arrays.setAll(modelWeights, v -> modelCounts[v] * modelWeights[v]);
        int[] counting = IntStream.range(0, targetWeights.length)
                .filter(v -> targetWeights[v] > 0)
                .toArray();
        int stride = 1 + counting.length / MAX_POINTS;
        points = IntStream.range(0, (counting.length + stride - 1) / stride)
                .map(i -> counting[i * stride])
                .toArray();
        pointWeights = Arrays.stream(points).mapToDouble(v -> targetWeights[v]).toArray();
        double targetArea = sum(targetWeights);
        double all = sum(modelWeights) + targetArea;
        double sampled = sum(pointWeights);
        Arrays.setAll(modelWeights, v -> modelWeights[v] / all);
        Arrays.setAll(pointWeights, i -> pointWeights[i] * (targetArea / sampled / all));
    }

    /** Sums in order. The compensated summation of a stream would give different bits. */
    private static double sum(double[] values) {
        double sum = 0;
        for (double value : values) {
            sum += value;
        }
        return sum;
    }

    /** Visits all distances for the given vertex positions of the part. */
    public void visit(double[] positions, Visitor visitor) {
        fromModel.refit(positions);
        double[] alone = {1, 0, 0};
        for (int v = 0; v < modelWeights.length; v++) {
            if (modelWeights[v] > 0) {
                double x = positions[3 * v];
                double y = positions[3 * v + 1];
                double z = positions[3 * v + 2];
                fromTarget.closest(x, y, z, hit);
                visit(modelWeights[v], x - hit.x, y - hit.y, z - hit.z, new int[] {v, v, v}, alone, visitor);
            }
        }
        for (int i = 0; i < points.length; i++) {
            int p = points[i];
            fromModel.closest(target.x(p), target.y(p), target.z(p), hit);
            int[] corners = Arrays.copyOfRange(rest.triangles(), 3 * hit.triangle, 3 * hit.triangle + 3);
            double[] shares = {hit.weightA, hit.weightB, hit.weightC};
            visit(
                    pointWeights[i],
                    hit.x - target.x(p),
                    hit.y - target.y(p),
                    hit.z - target.z(p),
                    corners,
                    shares,
                    visitor);
        }
    }

    private void visit(
            double weight, double dx, double dy, double dz, int[] vertices, double[] shares, Visitor visitor) {
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (length > 0) {
            direction[0] = dx / length;
            direction[1] = dy / length;
            direction[2] = dz / length;
            visitor.accept(weight, length, direction, vertices, shares);
        }
    }
}
