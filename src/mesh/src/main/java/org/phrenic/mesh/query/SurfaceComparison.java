package org.phrenic.mesh.query;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * Distances between two surfaces, from the vertices of each to the other surface ({@link SurfaceDistance}). After
 * Aspert et al. 2002, MESH (doi 10.1109/ICME.2002.1035879), and Roy, Foufou and Truchetet 2004, Mesh Comparison Using
 * Attribute Deviation Metric. Nearest-point distances do not measure motion along the surface. Distances between
 * corresponding vertices do; they are available if both meshes have the same triangles.
 *
 * @param aToB from the vertices of the first surface to the second surface
 * @param bToA from the vertices of the second surface to the first surface
 * @param perVertex statistics of both directions with equal vertex weights
 * @param byArea statistics of both directions, weighted by vertex area
 * @param corresponding statistics of the distances between vertices of the same index; empty if the triangles differ
 */
public record SurfaceComparison(
        DirectedDistances aToB,
        DirectedDistances bToA,
        DistanceSummary perVertex,
        DistanceSummary byArea,
        Optional<DistanceSummary> corresponding) {

    /**
     * Distances in one direction.
     *
     * @param distances one per vertex, mm; signed, positive outside, if the other surface is closed, manifold and
     *     oriented
     * @param weights vertex areas, mm^2; 0 for an unused vertex, which is excluded
     * @param signed whether distances are signed
     * @param perVertex statistics of absolute distances with equal vertex weights
     * @param byArea statistics of absolute distances, weighted by vertex area
     * @param signedMean area-weighted mean signed distance, mm; NaN if distances are unsigned
     */
    public record DirectedDistances(
            double[] distances,
            double[] weights,
            boolean signed,
            DistanceSummary perVertex,
            DistanceSummary byArea,
            double signedMean) {

        /** Distances from the vertices of {@code mesh} to the other surface. */
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

        /** Area-weighted histogram of the absolute distances. */
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
     * Compares two surfaces without registering them.
     *
     * @param a mm, with at least one triangle
     * @param b mm, in the same axes
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

    /** Computes only {@link #byArea()}, which is faster. */
    public static DistanceSummary summaryByArea(TriangleMesh a, TriangleMesh b) {
        return DistanceSummary.of(
                join(new TriangleTree(b).distances(a.positions()), new TriangleTree(a).distances(b.positions())),
                join(MeshMeasure.vertexAreas(a), MeshMeasure.vertexAreas(b)));
    }

    /** Symmetric Hausdorff distance, mm, taken at the vertices: the larger maximum of the two directions. */
    public double hausdorff() {
        return perVertex.maximum();
    }

    /** Distance between the vertices of the same index, mm. */
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
