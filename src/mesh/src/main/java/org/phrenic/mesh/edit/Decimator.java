package org.phrenic.mesh.edit;

import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Mesh decimation by quadric error metrics (Garland and Heckbert 1997, doi 10.1145/258734.258849). The edge with the
 * least quadric error collapses first, into the point that minimizes the error.
 *
 * <p>A collapse is rejected if it changes the topology (link condition, Dey et al. 1999), rotates a triangle normal by
 * more than 78 degrees or makes a triangle much thinner. It is also rejected if the new vertex, or the centre of a new
 * edge or triangle at it, is farther from the original surface than a bound. Boundary edges keep their position.
 */
public final class Decimator {
    /** Least cosine between a triangle's normals before and after a collapse: a rotation of 78 degrees. */
    private static final double MIN_COSINE = 0.2;
    /** Least {@link MovedTriangle#shapeAfter} of a triangle that a collapse makes thinner. */
    private static final double MIN_SHAPE = 0.2;
    /** Weight of the planes that preserve the boundary, relative to triangle planes. */
    private static final double BOUNDARY = 100;

    private final HalfEdgeMesh mesh;
    private final Quadrics quadrics;
    private final TriangleTree original;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final OneRing ring = new OneRing();
    private final MovedTriangle moved = new MovedTriangle();
    private final double bound;
    /** Current cost of each edge, indexed by its primary half-edge. A queue entry with a different cost is stale. */
    private final float[] costs;

    /** Queue entries: the cost as float bits in the high 32 bits, the half-edge in the low 32 bits. */
    private final LongHeap queue = new LongHeap();

    private Decimator(TriangleMesh given, double boundMm) {
        mesh = new HalfEdgeMesh(given);
        bound = boundMm;
        original = new TriangleTree(given);
        quadrics = new Quadrics(mesh.vertexEnd, given.centre());
        costs = new float[3 * mesh.triangleEnd];
    }

    /**
     * Decimates a surface.
     *
     * @param mesh consistently oriented ({@link MeshRepair#repair}); it is cut open where it is not manifold
     * @param vertices target number of vertices; the result has more if every further collapse is rejected
     * @param boundMm greatest distance of the result from the original surface, mm; infinite for no bound
     * @throws IllegalArgumentException if the target is below 4 vertices or the bound is not positive
     */
    public static TriangleMesh toVertexCount(TriangleMesh mesh, int vertices, double boundMm) {
        if (vertices < 4 || !(boundMm > 0)) {
            throw new IllegalArgumentException("decimation to " + vertices + " vertices within " + boundMm
                    + " mm, expected at least 4 vertices and more than 0 mm");
        }
        return new Decimator(mesh, boundMm).run(vertices);
    }

    private TriangleMesh run(int vertices) {
        for (int h = 0; h < 3 * mesh.triangleEnd; h += 3) {
            addPlanes(h);
        }
        for (int h = 0; h < 3 * mesh.triangleEnd; h++) {
            if (mesh.isPrimary(h)) {
                push(h);
            }
        }
        while (!queue.isEmpty() && mesh.vertexCount() > vertices) {
            long entry = queue.poll();
            int h = (int) entry;
            if (mesh.isAlive(h) && mesh.isPrimary(h) && costs[h] == Float.intBitsToFloat((int) (entry >> 32))) {
                tryCollapse(h);
            }
        }
        return mesh.toMesh();
    }

    private void addPlanes(int h) {
        int[] corners = {mesh.start[h], mesh.start[h + 1], mesh.start[h + 2]};
        double[] n = new double[3];
        double length = Triangles.cross(mesh.position, 3 * corners[0], 3 * corners[1], 3 * corners[2], n);
        if (length == 0) {
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            n[axis] /= length;
        }
        for (int v : corners) {
            quadrics.add(v, n[0], n[1], n[2], mesh.position, corners[0], length / 6);
        }
        for (int side = h; side < h + 3; side++) {
            if (mesh.twin[side] == HalfEdges.NONE) {
                addBoundary(side, n);
            }
        }
    }

    /** Adds the plane through a boundary edge, perpendicular to its triangle. */
    private void addBoundary(int side, double[] n) {
        double[] p = mesh.position;
        int a = mesh.start[side];
        int b = mesh.end(side);
        double ex = p[3 * b] - p[3 * a];
        double ey = p[3 * b + 1] - p[3 * a + 1];
        double ez = p[3 * b + 2] - p[3 * a + 2];
        double square = ex * ex + ey * ey + ez * ez;
        double length = Math.sqrt(square);
        if (length > 0) {
            double x = (ey * n[2] - ez * n[1]) / length;
            double y = (ez * n[0] - ex * n[2]) / length;
            double z = (ex * n[1] - ey * n[0]) / length;
            quadrics.add(a, x, y, z, p, a, BOUNDARY * square);
            quadrics.add(b, x, y, z, p, a, BOUNDARY * square);
        }
    }

    /** Finds the point of least quadric error for an edge; returns the error. */
    private double minimize(int h) {
        double[] p = mesh.position;
        int a = mesh.start[h];
        int b = mesh.end(h);
        return quadrics.minimize(
                a, b, (p[3 * a] + p[3 * b]) / 2, (p[3 * a + 1] + p[3 * b + 1]) / 2, (p[3 * a + 2] + p[3 * b + 2]) / 2);
    }

    private void tryCollapse(int h) {
        if (!mesh.canCollapse(h)) {
            return;
        }
        int a = mesh.start[h];
        int b = mesh.end(h);
        minimize(h);
        double x = quadrics.x;
        double y = quadrics.y;
        double z = quadrics.z;
        // The distance to the original surface is the most expensive test, so it comes last.
        boolean fits = everyTriangle(a, b, (c, d) -> keepsShape(a, c, d, x, y, z))
                && everyTriangle(b, a, (c, d) -> keepsShape(b, c, d, x, y, z))
                && isNear(x, y, z)
                && everyTriangle(a, b, (c, d) -> staysNear(c, d, x, y, z))
                && everyTriangle(b, a, (c, d) -> staysNear(c, d, x, y, z));
        if (!fits) {
            return;
        }
        quadrics.merge(a, b);
        mesh.collapse(h, x, y, z);
        int g = mesh.out[b];
        do {
            pushEdge(g);
            int back = HalfEdges.previous(g);
            pushEdge(back);
            g = mesh.twin[back];
        } while (g != HalfEdges.NONE && g != mesh.out[b]);
    }

    /** A predicate on the edge opposite a vertex in one of its triangles. */
    private interface OppositeSide {
        boolean test(int b, int c);
    }

    /** Whether a predicate holds for all triangles at {@code v} that do not contain {@code gone}. */
    private boolean everyTriangle(int v, int gone, OppositeSide test) {
        mesh.collectRing(v, ring);
        for (int i = 0; i < ring.triangles; i++) {
            if (!ring.triangleHas(i, gone) && !test.test(ring.vertices[i], ring.next(i))) {
                return false;
            }
        }
        return true;
    }

    private boolean keepsShape(int v, int b, int c, double x, double y, double z) {
        moved.set(mesh.position, v, b, c, x, y, z);
        double shape = moved.shapeAfter();
        return !(moved.dot < MIN_COSINE * Math.sqrt(moved.before * moved.after))
                && !(shape < MIN_SHAPE && shape < moved.shapeBefore());
    }

    /** Whether the centroid of triangle (x, y, z), b, c and the midpoint of its edge to b are within the bound. */
    private boolean staysNear(int b, int c, double x, double y, double z) {
        double[] p = mesh.position;
        return isNear((x + p[3 * b]) / 2, (y + p[3 * b + 1]) / 2, (z + p[3 * b + 2]) / 2)
                && isNear(
                        (x + p[3 * b] + p[3 * c]) / 3,
                        (y + p[3 * b + 1] + p[3 * c + 1]) / 3,
                        (z + p[3 * b + 2] + p[3 * c + 2]) / 3);
    }

    private boolean isNear(double x, double y, double z) {
        return bound == Double.POSITIVE_INFINITY || original.isWithin(x, y, z, bound, hit);
    }

    private void pushEdge(int h) {
        push(mesh.isPrimary(h) ? h : mesh.twin[h]);
    }

    /** Enqueues an edge. The bits of a non-negative float sort like its value; the half-edge index breaks ties. */
    private void push(int h) {
        costs[h] = (float) minimize(h);
        queue.add((long) Float.floatToRawIntBits(costs[h]) << 32 | h);
    }
}
