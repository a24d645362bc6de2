package org.phrenic.mesh;

import java.util.Arrays;

/**
 * Quality figures of a mesh for mass-spring models: the smallest angles are far from 0 without slivers, and edges of
 * equal length have a ratio of 1.
 *
 * @param vertices count
 * @param triangles count
 * @param smallestAngleDeg of all triangles; an equilateral one has 60
 * @param firstPercentileAngleDeg one triangle in a hundred has a smallest angle below this
 * @param shortestEdgeMm mm
 * @param meanEdgeMm mm
 * @param longestEdgeMm mm
 */
public record MeshQuality(
        int vertices,
        int triangles,
        double smallestAngleDeg,
        double firstPercentileAngleDeg,
        double shortestEdgeMm,
        double meanEdgeMm,
        double longestEdgeMm) {
    public static MeshQuality of(TriangleMesh mesh) {
        double[] angles = sortedAngles(mesh);
        MeshMeasure.EdgeLengths edges = MeshMeasure.edgeLengthSummary(mesh, new MeshTopology(mesh));
        boolean empty = angles.length == 0;
        return new MeshQuality(
                mesh.vertexCount(),
                mesh.triangleCount(),
                empty ? 0 : angles[0],
                firstPercentile(angles),
                edges.minimum(),
                edges.mean(),
                edges.maximum());
    }

    /** {@link #firstPercentileAngleDeg()} alone. */
    public static double firstPercentileAngleDeg(TriangleMesh mesh) {
        return firstPercentile(sortedAngles(mesh));
    }

    private static double[] sortedAngles(TriangleMesh mesh) {
        double[] angles = MeshMeasure.smallestAngles(mesh);
        Arrays.sort(angles);
        return angles;
    }

    private static double firstPercentile(double[] angles) {
        return angles.length == 0 ? 0 : angles[angles.length / 100];
    }

    /** Longest over shortest edge. */
    public double edgeRatio() {
        return shortestEdgeMm > 0 ? longestEdgeMm / shortestEdgeMm : Double.POSITIVE_INFINITY;
    }
}
