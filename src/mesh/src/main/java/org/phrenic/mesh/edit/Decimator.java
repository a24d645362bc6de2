package org.phrenic.mesh.edit;

import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Takes vertices out of a surface where they matter least (Garland and Heckbert 1997, doi 10.1145/258734.258849): edges
 * collapse to the place nearest the planes of all triangles that went into them, the least error first. No collapse
 * changes the topology (link condition, Dey et al. 1999), turns a triangle by more than 78 degrees, makes a triangle
 * much thinner than it found it, or leads the surface farther from the original than a bound: the new vertex and the
 * middles of the new edges and triangles about it are held to it. Boundaries keep their place.
 */
public final class Decimator {
    /** Least cosine between a triangle's normals before and after: a turn of 78 degrees. */
    private static final double LEAST_COSINE = 0.2;
    /**
     * Twice the area over the squared longest side, below which a triangle may not fall; an equilateral one has 0.87.
     */
    private static final double LEAST_SHAPE = 0.2;
    /** Planes that hold a boundary weigh so much more than those of triangles. */
    private static final double BOUNDARY = 100;

    private final HalfEdgeMesh mesh;
    private final Quadrics quadrics;
    private final TriangleTree original;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final double bound;
    /** Cost of the edge that each half-edge stands for, as last worked out; a queue entry with another one is old. */
    private final float[] costs;

    private long[] heap = new long[1024];
    private int size;
    private int[] ring = new int[64];
    private int ringSize;

    private Decimator(TriangleMesh given, double boundMm) {
        mesh = new HalfEdgeMesh(given);
        bound = boundMm;
        original = new TriangleTree(given);
        double[] box = given.bounds();
        quadrics = new Quadrics(
                mesh.vertexEnd, new double[] {(box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2});
        costs = new float[3 * mesh.triangleEnd];
    }

    /**
     * A surface of fewer vertices.
     *
     * @param mesh consistently oriented ({@link MeshRepair#repair}); where it is not manifold it is cut open
     * @param vertices how many are wanted; more are left where fewer would break a rule
     * @param boundMm how far from the original the surface may lead, mm; infinite for no bound
     * @throws IllegalArgumentException if fewer than 4 vertices are asked for or the bound is not above 0
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
        while (size > 0 && mesh.vertexCount() > vertices) {
            long entry = pop();
            int h = (int) entry;
            // An edge whose ends have changed since has another entry.
            if (mesh.isAlive(h) && mesh.isPrimary(h) && costs[h] == Float.intBitsToFloat((int) (entry >> 32))) {
                tryCollapse(h);
            }
        }
        return mesh.toMesh();
    }

    private void addPlanes(int h) {
        double[] p = mesh.position;
        int a = mesh.start[h];
        int b = mesh.start[h + 1];
        int c = mesh.start[h + 2];
        double[] n = cross(a, b, p[3 * c], p[3 * c + 1], p[3 * c + 2]);
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (length == 0) {
            return;
        }
        double x = n[0] / length;
        double y = n[1] / length;
        double z = n[2] / length;
        for (int v : new int[] {a, b, c}) {
            quadrics.add(v, x, y, z, p[3 * a], p[3 * a + 1], p[3 * a + 2], length / 6);
        }
        for (int side = h; side < h + 3; side++) {
            if (mesh.twin[side] == HalfEdgeMesh.NONE) {
                addBoundary(side, x, y, z);
            }
        }
    }

    /** The plane through a boundary edge, across its triangle. */
    private void addBoundary(int side, double nx, double ny, double nz) {
        double[] p = mesh.position;
        int a = mesh.start[side];
        int b = mesh.end(side);
        double ex = p[3 * b] - p[3 * a];
        double ey = p[3 * b + 1] - p[3 * a + 1];
        double ez = p[3 * b + 2] - p[3 * a + 2];
        double square = ex * ex + ey * ey + ez * ez;
        double length = Math.sqrt(square);
        if (length > 0) {
            double x = (ey * nz - ez * ny) / length;
            double y = (ez * nx - ex * nz) / length;
            double z = (ex * ny - ey * nx) / length;
            quadrics.add(a, x, y, z, p[3 * a], p[3 * a + 1], p[3 * a + 2], BOUNDARY * square);
            quadrics.add(b, x, y, z, p[3 * a], p[3 * a + 1], p[3 * a + 2], BOUNDARY * square);
        }
    }

    /** Works out the best place of an edge's ends together. */
    private double place(int h) {
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
        place(h);
        double x = quadrics.x;
        double y = quadrics.y;
        double z = quadrics.z;
        boolean fits = keepsSides(a, b, x, y, z) && keepsSides(b, a, x, y, z);
        // The search for the original costs most and comes last.
        if (!fits || !isNear(x, y, z) || !staysNear(a, b, x, y, z) || !staysNear(b, a, x, y, z)) {
            return;
        }
        quadrics.merge(a, b);
        mesh.collapse(h, x, y, z);
        int g = mesh.out[b];
        do {
            pushEdge(g);
            int back = HalfEdgeMesh.previous(g);
            pushEdge(back);
            g = mesh.twin[back];
        } while (g != HalfEdgeMesh.NONE && g != mesh.out[b]);
    }

    private void pushEdge(int h) {
        push(mesh.isPrimary(h) ? h : mesh.twin[h]);
    }

    private boolean isNear(double x, double y, double z) {
        return bound == Double.POSITIVE_INFINITY || original.isWithin(x, y, z, bound, hit);
    }

    /** Fills {@link #ring} about {@code v}; returns how many triangles it has. */
    private int gather(int v) {
        mesh.collectRing(v);
        ringSize = mesh.ringSize;
        if (ring.length < ringSize) {
            ring = new int[2 * ringSize];
        }
        System.arraycopy(mesh.ring, 0, ring, 0, ringSize);
        return mesh.isBoundaryVertex(v) ? ringSize - 1 : ringSize;
    }

    /** Whether the triangles at {@code v} that do not hold {@code gone} keep side and shape when v moves. */
    private boolean keepsSides(int v, int gone, double x, double y, double z) {
        int triangles = gather(v);
        double[] p = mesh.position;
        for (int i = 0; i < triangles; i++) {
            int b = ring[i];
            int c = ring[i + 1 == ringSize ? 0 : i + 1];
            if (b == gone || c == gone) {
                continue;
            }
            double[] before = cross(b, c, p[3 * v], p[3 * v + 1], p[3 * v + 2]);
            double[] after = cross(b, c, x, y, z);
            double squareBefore = Vectors.dot(before, before);
            double squareAfter = Vectors.dot(after, after);
            double shapeBefore = Math.sqrt(squareBefore) / longestSquare(b, c, p[3 * v], p[3 * v + 1], p[3 * v + 2]);
            double shapeAfter = Math.sqrt(squareAfter) / longestSquare(b, c, x, y, z);
            boolean turned = Vectors.dot(before, after) < LEAST_COSINE * Math.sqrt(squareBefore * squareAfter);
            if (turned || (shapeAfter < LEAST_SHAPE && shapeAfter < shapeBefore)) {
                return false;
            }
        }
        return true;
    }

    /** Whether the middles of the same triangles and of their edges at v are within the bound when v moves. */
    private boolean staysNear(int v, int gone, double x, double y, double z) {
        int triangles = gather(v);
        double[] p = mesh.position;
        for (int i = 0; i < triangles; i++) {
            int b = ring[i];
            int c = ring[i + 1 == ringSize ? 0 : i + 1];
            if (b == gone || c == gone) {
                continue;
            }
            boolean near = isNear((x + p[3 * b]) / 2, (y + p[3 * b + 1]) / 2, (z + p[3 * b + 2]) / 2)
                    && isNear(
                            (x + p[3 * b] + p[3 * c]) / 3,
                            (y + p[3 * b + 1] + p[3 * c + 1]) / 3,
                            (z + p[3 * b + 2] + p[3 * c + 2]) / 3);
            if (!near) {
                return false;
            }
        }
        return true;
    }

    /** (c - b) x (point - b), twice the area of the triangle they make. */
    private double[] cross(int b, int c, double x, double y, double z) {
        double[] p = mesh.position;
        double ex = p[3 * c] - p[3 * b];
        double ey = p[3 * c + 1] - p[3 * b + 1];
        double ez = p[3 * c + 2] - p[3 * b + 2];
        double ux = x - p[3 * b];
        double uy = y - p[3 * b + 1];
        double uz = z - p[3 * b + 2];
        return new double[] {ey * uz - ez * uy, ez * ux - ex * uz, ex * uy - ey * ux};
    }

    private double longestSquare(int b, int c, double x, double y, double z) {
        double[] p = mesh.position;
        double one = square(p[3 * b] - x, p[3 * b + 1] - y, p[3 * b + 2] - z);
        double two = square(p[3 * c] - x, p[3 * c + 1] - y, p[3 * c + 2] - z);
        double three = square(p[3 * c] - p[3 * b], p[3 * c + 1] - p[3 * b + 1], p[3 * c + 2] - p[3 * b + 2]);
        return Math.max(Double.MIN_NORMAL, Math.max(one, Math.max(two, three)));
    }

    private static double square(double x, double y, double z) {
        return x * x + y * y + z * z;
    }

    /** Enters an edge: the bits of a float that is not negative sort as it does, the half-edge breaks ties. */
    private void push(int h) {
        costs[h] = (float) place(h);
        if (size == heap.length) {
            heap = Arrays.copyOf(heap, 2 * size);
        }
        long entry = (long) Float.floatToRawIntBits(costs[h]) << 32 | h;
        int i = size++;
        while (i > 0 && heap[(i - 1) >> 1] > entry) {
            heap[i] = heap[(i - 1) >> 1];
            i = (i - 1) >> 1;
        }
        heap[i] = entry;
    }

    private long pop() {
        long least = heap[0];
        long last = heap[--size];
        int i = 0;
        while (2 * i + 1 < size) {
            int below = 2 * i + 1;
            if (below + 1 < size && heap[below + 1] < heap[below]) {
                below++;
            }
            if (heap[below] >= last) {
                break;
            }
            heap[i] = heap[below];
            i = below;
        }
        heap[i] = last;
        return least;
    }
}
