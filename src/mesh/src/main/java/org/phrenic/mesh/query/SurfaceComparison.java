package org.phrenic.mesh.query;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * How far two surfaces lie apart: from the vertices of each to the other, exactly ({@link SurfaceDistance}), after
 * Aspert et al. 2002, MESH (doi 10.1109/ICME.2002.1035879), and Roy, Foufou and Truchetet 2004, Mesh Comparison Using
 * Attribute Deviation Metric. Distances to nearest points do not see motion along the surface; distances of
 * corresponding vertices do, where both have the same triangles.
 *
 * @param aToB from the vertices of the first to the second surface
 * @param bToA from the vertices of the second to the first
 * @param perVertex of both directions together, every vertex counting the same
 * @param byArea of both directions together, a vertex counting as the area about it
 * @param corresponding of the distances between vertices of one number; empty if the triangles differ
 */
public record SurfaceComparison(
        DirectedDistances aToB,
        DirectedDistances bToA,
        DistanceSummary perVertex,
        DistanceSummary byArea,
        Optional<DistanceSummary> corresponding) {

    /**
     * One direction.
     *
     * @param distances one a vertex, mm; with a sign, positive outside, where the other surface is closed
     * @param weights area about each vertex, mm^2; 0 for one that no triangle uses, which counts nowhere
     * @param signed whether distances have a sign
     * @param perVertex figures of the sizes, every vertex counting the same
     * @param byArea figures of the sizes, a vertex counting as the area about it
     * @param signedMean area-weighted mean signed distance, mm; NaN without signs
     */
    public record DirectedDistances(
            double[] distances,
            double[] weights,
            boolean signed,
            DistanceSummary perVertex,
            DistanceSummary byArea,
            double signedMean) {

        /** Figures of the vertices of {@code mesh}. */
        static DirectedDistances of(TriangleMesh mesh, SurfaceDistance other) {
            double[] p = mesh.positions();
            double[] distances = other.isSigned() ? other.signedDistance(p) : other.unsignedDistance(p);
            double[] areas = MeshMeasure.vertexAreas(mesh);
            return new DirectedDistances(
                    distances,
                    areas,
                    other.isSigned(),
                    DistanceSummary.of(distances, used(mesh)),
                    DistanceSummary.of(distances, areas),
                    other.isSigned() ? mean(distances, areas) : Double.NaN);
        }

        /** How the sizes spread, weighted by area. */
        public DistanceHistogram histogram(int bins) {
            return DistanceHistogram.of(distances, weights, bins);
        }

        private static double mean(double[] distances, double[] weights) {
            double sum = 0;
            double total = 0;
            for (int i = 0; i < distances.length; i++) {
                sum += weights[i] * distances[i];
                total += weights[i];
            }
            return total > 0 ? sum / total : 0;
        }
    }

    /**
     * Compares two surfaces as they lie.
     *
     * @param a mm, with at least one triangle
     * @param b in the same axes
     * @throws IllegalArgumentException if one has no triangle
     */
    public static SurfaceComparison of(TriangleMesh a, TriangleMesh b) {
        if (a.triangleCount() == 0 || b.triangleCount() == 0) {
            throw new IllegalArgumentException("comparing " + a + " and " + b + ", expected surfaces with triangles");
        }
        DirectedDistances aToB = DirectedDistances.of(a, new SurfaceDistance(b));
        DirectedDistances bToA = DirectedDistances.of(b, new SurfaceDistance(a));
        double[] both = join(aToB.distances(), bToA.distances());
        return new SurfaceComparison(
                aToB,
                bToA,
                DistanceSummary.of(both, join(used(a), used(b))),
                DistanceSummary.of(both, join(aToB.weights(), bToA.weights())),
                Arrays.equals(a.triangles(), b.triangles()) && a.vertexCount() == b.vertexCount()
                        ? Optional.of(DistanceSummary.of(displacements(a, b), used(a)))
                        : Optional.empty());
    }

    /** What {@link #byArea()} says, for a part of the work. */
    public static DistanceSummary summaryByArea(TriangleMesh a, TriangleMesh b) {
        return DistanceSummary.of(
                join(new TriangleTree(b).distances(a.positions()), new TriangleTree(a).distances(b.positions())),
                join(MeshMeasure.vertexAreas(a), MeshMeasure.vertexAreas(b)));
    }

    /** The larger of the largest distances of the two directions, mm; taken at vertices. */
    public double hausdorff() {
        return perVertex.maximum();
    }

    /** How far each vertex of one surface lies from the vertex of the same number of another, mm. */
    public static double[] displacements(TriangleMesh a, TriangleMesh b) {
        double[] out = new double[a.vertexCount()];
        for (int v = 0; v < out.length; v++) {
            double dx = b.x(v) - a.x(v);
            double dy = b.y(v) - a.y(v);
            double dz = b.z(v) - a.z(v);
            out[v] = Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        return out;
    }

    /** 1 for a vertex that a triangle uses, 0 for others. */
    private static double[] used(TriangleMesh mesh) {
        double[] used = new double[mesh.vertexCount()];
        for (int v : mesh.triangles()) {
            used[v] = 1;
        }
        return used;
    }

    private static double[] join(double[] first, double[] second) {
        double[] both = Arrays.copyOf(first, first.length + second.length);
        System.arraycopy(second, 0, both, first.length, second.length);
        return both;
    }
}
