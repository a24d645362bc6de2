package org.phrenic.mesh;

import java.util.Arrays;

/**
 * Mesh quality measures for mass-spring models. A good mesh has smallest angles near 60 degrees and an edge ratio near
 * 1.
 *
 * @param vertices number of vertices
 * @param triangles number of triangles
 * @param smallestAngleDeg smallest angle of all triangles, degrees; 60 if all are equilateral
 * @param firstPercentileAngleDeg first percentile of the triangles' smallest angles, degrees
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

    /** Computes only {@link #firstPercentileAngleDeg()}. */
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

    /** Ratio of the longest to the shortest edge. */
    public double edgeRatio() {
        return shortestEdgeMm > 0 ? longestEdgeMm / shortestEdgeMm : Double.POSITIVE_INFINITY;
    }
}
