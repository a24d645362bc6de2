package org.phrenic.geometry;

import java.util.Arrays;

/**
 * What a mesh is like for springs: without slivers its smallest angles are far from 0 and its edges of one length.
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
        double[] angles = MeshMeasure.smallestAngles(mesh);
        Arrays.sort(angles);
        MeshMeasure.EdgeLengths edges = MeshMeasure.edgeLengthSummary(mesh, new MeshTopology(mesh));
        boolean empty = angles.length == 0;
        return new MeshQuality(
                mesh.vertexCount(),
                mesh.triangleCount(),
                empty ? 0 : angles[0],
                empty ? 0 : angles[angles.length / 100],
                edges.minimum(),
                edges.mean(),
                edges.maximum());
    }

    /** Longest over shortest edge. */
    public double edgeRatio() {
        return shortestEdgeMm > 0 ? longestEdgeMm / shortestEdgeMm : Double.POSITIVE_INFINITY;
    }
}
