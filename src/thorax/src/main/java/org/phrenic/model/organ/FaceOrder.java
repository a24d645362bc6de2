package org.phrenic.model.organ;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.OpposingVertices;
import org.phrenic.engine.constraint.NonInversionPairs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/** Pairs of opposing vertices on the two faces of a diaphragm that must not invert. */
final class FaceOrder {
    /** Minimum separation of the two faces of muscle, as a share of their distance at rest, and its upper limit. */
    private static final double MIN_SEPARATION_SHARE = 0.4;

    private static final double MIN_SEPARATION_MM = 1.5;
    /**
     * Minimum cosine between a pair and the surface normal. A more oblique pair, as at the rim of an opening, does not
     * define inside and outside; constraining such pairs made nodes oscillate by millimetres.
     */
    private static final double UPRIGHT = 0.5;

    private final Diaphragm diaphragm;
    private final List<OrderedPair> uprightPairs;

    /**
     * @param pairs opposing vertices, each vertex in at most one pair; only pairs nearly normal to the sheet are used
     */
    FaceOrder(Diaphragm diaphragm, List<OpposingVertices.Pair> pairs) {
        this.diaphragm = diaphragm;
        uprightPairs = uprightPairs(pairs);
    }

    /** The constraint on scene nodes; {@code firstNode} is the node of the first vertex. */
    NonInversionPairs constraint(NodeLayout layout, int firstNode, double refresh) {
        int[] t = diaphragm.sheet().triangles();
        int[] outer = uprightPairs.stream().mapToInt(p -> firstNode + p.outer).toArray();
        int[] inner = uprightPairs.stream().mapToInt(p -> firstNode + p.inner).toArray();
        int[][] rings = uprightPairs.stream()
                .map(p -> Arrays.stream(p.ring)
                        .flatMap(triangle -> IntStream.range(3 * triangle, 3 * triangle + 3))
                        .map(c -> firstNode + t[c])
                        .toArray())
                .toArray(int[][]::new);
        double[] separation =
                uprightPairs.stream().mapToDouble(p -> p.minSeparation).toArray();
        return new NonInversionPairs(layout, outer, inner, rings, separation, refresh);
    }

    /**
     * Two opposing vertices that must not invert.
     *
     * @param ring triangles at the outer vertex; their normals point outward
     * @param minSeparation minimum distance along their mean normal, mm
     */
    private record OrderedPair(int outer, int inner, int[] ring, double minSeparation) {}

    /** The pairs across muscle that are nearly normal to the sheet. */
    private List<OrderedPair> uprightPairs(List<OpposingVertices.Pair> pairs) {
        TriangleMesh s = diaphragm.sheet();
        MeshTopology topology = diaphragm.topology();
        double[] p = s.positions();
        double[] normals = MeshMeasure.vertexNormals(s);
        List<OrderedPair> out = new ArrayList<>();
        for (OpposingVertices.Pair pair : pairs) {
            int a = diaphragm.isThoracic(pair.a()) ? pair.a() : pair.b();
            int b = a == pair.a() ? pair.b() : pair.a();
            double along = distanceAlongNormal(p, normals, a, b);
            if (along > UPRIGHT * MassSpringBuilder.distance(p, a, p, b)) {
                int[] ring = Arrays.copyOfRange(
                        topology.vertexTriangles(),
                        topology.vertexTriangleStart()[a],
                        topology.vertexTriangleStart()[a + 1]);
                out.add(new OrderedPair(a, b, ring, Math.min(MIN_SEPARATION_MM, MIN_SEPARATION_SHARE * along)));
            }
        }
        return out;
    }

    /** Distance of a from b along the normal of a. */
    private static double distanceAlongNormal(double[] p, double[] normals, int a, int b) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum += normals[3 * a + axis] * (p[3 * a + axis] - p[3 * b + axis]);
        }
        return sum;
    }
}
