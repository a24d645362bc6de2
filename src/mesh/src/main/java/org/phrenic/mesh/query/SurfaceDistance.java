package org.phrenic.mesh.query;

import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * Exact distances from points to a surface, mm. They are signed, positive outside, if the surface is closed, manifold
 * and consistently oriented. The sign is that of the angle-weighted pseudonormal of the face, edge or vertex that
 * contains the nearest point (Baerentzen and Aanaes 2005, doi 10.1109/TVCG.2005.49).
 *
 * <p>Not thread-safe. {@link #refit} moves the vertices of the reference surface.
 */
public final class SurfaceDistance {
    /** If a barycentric weight is below this, the nearest point is on the opposite side of its triangle. */
    private static final double ON_SIDE = 1e-12;

    private final TriangleTree tree;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final MeshTopology topology;
    private final boolean signed;
    private double[] faceNormals = new double[0];
    private double[] vertexNormals = new double[0];
    private double outward = 1;

    /** @param reference mm */
    public SurfaceDistance(TriangleMesh reference) {
        tree = new TriangleTree(reference);
        topology = new MeshTopology(reference);
        signed = reference.triangleCount() > 0 && topology.isClosed() && topology.isManifold() && isOriented(reference);
        findNormals(reference);
    }

    /** Moves the vertices of the reference surface; the triangles remain. */
    public void refit(double[] positions) {
        tree.refit(positions);
        findNormals(tree.mesh().withPositions(positions));
    }

    /** Whether each edge is traversed once in each direction. */
    private boolean isOriented(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        int[] sides = topology.edgeOfSide();
        int[] balance = new int[topology.edgeCount()];
        for (int side = 0; side < t.length; side++) {
            if (sides[side] >= 0) {
                balance[sides[side]] += t[side] < t[EdgeTable.next(side, 3)] ? 1 : -1;
            }
        }
        for (int b : balance) {
            if (b != 0) {
                return false;
            }
        }
        return true;
    }

    private void findNormals(TriangleMesh mesh) {
        if (signed) {
            faceNormals = MeshMeasure.triangleNormals(mesh);
            vertexNormals = MeshMeasure.vertexNormals(mesh);
            outward = MeshMeasure.signedVolume(mesh) < 0 ? -1 : 1;
        }
    }

    /** Whether distances are signed. */
    public boolean isSigned() {
        return signed;
    }

    /**
     * Unsigned distances of points; infinite if the reference has no triangle.
     *
     * @param points x, y, z in turn
     * @return one distance per point, mm
     */
    public double[] unsignedDistance(double[] points) {
        return tree.distances(points);
    }

    /** Unsigned distance of one point, mm. */
    public double unsignedDistance(double x, double y, double z) {
        tree.closest(x, y, z, hit);
        return Math.sqrt(hit.distanceSquared);
    }

    /**
     * Signed distances of points, negative inside; infinite for a point with a coordinate that is not a number.
     *
     * @throws IllegalStateException if the reference is not closed, manifold and oriented, see {@link #isSigned}
     */
    public double[] signedDistance(double[] points) {
        if (!signed) {
            throw new IllegalStateException("signed distance from " + tree.mesh() + ", expected a closed surface");
        }
        double[] out = new double[points.length / 3];
        for (int i = 0; i < out.length; i++) {
            double x = points[3 * i];
            double y = points[3 * i + 1];
            double z = points[3 * i + 2];
            tree.closest(x, y, z, hit);
            out[i] = Math.copySign(Math.sqrt(hit.distanceSquared), side(x, y, z));
        }
        return out;
    }

    /**
     * Signed distances of points, negative inside; of a reference that is not closed, manifold and oriented, inside is
     * where its rounded winding number is not 0 ({@link TriangleTree#isInside}), which takes a pass over all triangles.
     */
    public double[] sidedDistance(double[] points) {
        if (signed) {
            return signedDistance(points);
        }
        double[] out = unsignedDistance(points);
        for (int i = 0; i < out.length; i++) {
            out[i] = tree.isInside(points[3 * i], points[3 * i + 1], points[3 * i + 2]) ? -out[i] : out[i];
        }
        return out;
    }

    /** Positive outside, negative inside, for the query point of the last hit. */
    private double side(double x, double y, double z) {
        int t = hit.triangle;
        if (t < 0) {
            return 1;
        }
        int sideOfA = 3 * t;
        double dx = x - hit.x;
        double dy = y - hit.y;
        double dz = z - hit.z;
        if (isZero(faceNormals, t)) {
            // A degenerate triangle has no normal.
            return tree.isInside(x, y, z) ? -1 : 1;
        }
        boolean a = hit.weightA > ON_SIDE;
        boolean b = hit.weightB > ON_SIDE;
        boolean c = hit.weightC > ON_SIDE;
        if (a && b && c) {
            return outward * along(faceNormals, t, dx, dy, dz);
        }
        boolean atCorner = a ? !b && !c : b != c;
        if (atCorner) {
            int corner = a ? 0 : b ? 1 : 2;
            return outward * along(vertexNormals, tree.mesh().triangles()[sideOfA + corner], dx, dy, dz);
        }
        int edge = topology.edgeOfSide()[sideOfA + (!c ? 0 : !a ? 1 : 2)];
        int other = topology.otherFace(edge, t);
        return outward * (along(faceNormals, t, dx, dy, dz) + along(faceNormals, other, dx, dy, dz));
    }

    private static boolean isZero(double[] vectors, int i) {
        return vectors[3 * i] == 0 && vectors[3 * i + 1] == 0 && vectors[3 * i + 2] == 0;
    }

    private static double along(double[] vectors, int i, double x, double y, double z) {
        return vectors[3 * i] * x + vectors[3 * i + 1] * y + vectors[3 * i + 2] * z;
    }
}
