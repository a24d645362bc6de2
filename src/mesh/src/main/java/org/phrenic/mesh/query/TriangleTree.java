package org.phrenic.mesh.query;

import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;

/**
 * A tree of axis-aligned boxes over the triangles of a mesh: nearest point, rays, inside or outside. Boxes are halved
 * at the median triangle along their longest axis, down to four triangles; nodes lie in flat arrays, the left child
 * after its parent. The corners are copied in leaf order, so a query reads memory in a row.
 *
 * <p>Queries allocate nothing and may run on several threads, each with a {@link Hit} of its own; {@link #refit} may
 * not run beside them.
 */
public final class TriangleTree {
    private static final int LEAF_TRIANGLES = 4;
    private static final int NO_LIMIT = 0;

    private final TriangleMesh mesh;
    /** Triangle numbers in leaf order. */
    final int[] order;
    /** Nine corner coordinates a triangle, in leaf order. */
    final double[] corners;

    private final double[] normal = new double[3];
    /** Unit normal a triangle, in leaf order. */
    private final double[] normals;

    private final boolean[] flat;
    /** Six numbers a node: minimum, then maximum. */
    final double[] boxes;
    /** Right child of an inner node; -1 - (first place in leaf order) of a leaf. */
    final int[] child;
    /** Triangles below the node, counted from its first place. */
    final int[] count;

    final int nodes;

    /** The answer to a query, and its working memory: make one a thread and use it again. */
    public static final class Hit {
        /** Triangle found, -1 if none. */
        public int triangle = -1;
        /** Weights of the triangle's three corners, which sum to 1. */
        public double weightA;

        public double weightB;
        public double weightC;
        /** The point on the triangle, mm. */
        public double x;

        public double y;
        public double z;
        /** Squared distance to the point asked about, mm^2; infinite if none was found. */
        public double distanceSquared = Double.POSITIVE_INFINITY;
        /** For a ray: the multiple of its direction at which it meets the triangle. */
        public double rayParameter = Double.POSITIVE_INFINITY;

        final int[] stack = new int[64];
        final double[] stackDistance = new double[64];
        final double[] weights = new double[2];
        int leafPlace;
    }

    public TriangleTree(TriangleMesh mesh) {
        this.mesh = mesh;
        int n = mesh.triangleCount();
        TriangleTreeBuilder builder = new TriangleTreeBuilder(mesh, LEAF_TRIANGLES);
        order = builder.order();
        child = builder.child();
        count = builder.count();
        nodes = builder.nodes();
        boxes = new double[6 * nodes];
        corners = new double[9 * n];
        normals = new double[3 * n];
        flat = new boolean[n];
        refit(mesh.positions());
    }

    public TriangleMesh mesh() {
        return mesh;
    }

    /** Moves the vertices: boxes are drawn again about the same triangles, in one pass. */
    public void refit(double[] positions) {
        if (positions.length != 3 * mesh.vertexCount()) {
            throw new IllegalArgumentException(
                    "positions: " + positions.length + " numbers, expected " + 3 * mesh.vertexCount());
        }
        int[] t = mesh.triangles();
        for (int place = 0; place < order.length; place++) {
            int o = 9 * place;
            for (int k = 0; k < 3; k++) {
                int v = 3 * t[3 * order[place] + k];
                corners[o + 3 * k] = positions[v];
                corners[o + 3 * k + 1] = positions[v + 1];
                corners[o + 3 * k + 2] = positions[v + 2];
            }
            double length = Triangles.cross(corners, o, o + 3, o + 6, normal);
            double scale = length > 0 ? 1 / length : 0;
            for (int k = 0; k < 3; k++) {
                normals[3 * place + k] = normal[k] * scale;
            }
            flat[place] = PointTriangleDistance.isDegenerate(corners, o);
        }
        for (int node = nodes - 1; node >= 0; node--) {
            if (child[node] < 0) {
                boxOfLeaf(node);
            } else {
                int right = 6 * child[node];
                System.arraycopy(boxes, 6 * (node + 1), boxes, 6 * node, 6);
                BoundingBoxes.include(boxes, 6 * node, boxes, right);
                BoundingBoxes.include(boxes, 6 * node, boxes, right + 3);
            }
        }
    }

    private void boxOfLeaf(int node) {
        BoundingBoxes.setEmpty(boxes, 6 * node);
        int from = 9 * (-1 - child[node]);
        for (int i = from; i < from + 9 * count[node]; i += 3) {
            BoundingBoxes.include(boxes, 6 * node, corners, i);
        }
    }

    /** The point of the surface nearest to (x, y, z). True if the mesh has a triangle. */
    public boolean closest(double x, double y, double z, Hit out) {
        return search(x, y, z, Double.POSITIVE_INFINITY, 0, 0, 0, NO_LIMIT, false, out);
    }

    /**
     * As {@link #closest(double, double, double, Hit)} within {@code maximumDistance} mm; false if nothing is that
     * near.
     */
    public boolean closest(double x, double y, double z, double maximumDistance, Hit out) {
        return search(x, y, z, maximumDistance * maximumDistance, 0, 0, 0, NO_LIMIT, false, out);
    }

    /**
     * As {@link #closest(double, double, double, double, Hit)}, among triangles whose unit normal n has n . (nx, ny,
     * nz) &gt; {@code minimumCosine}: on a thin sheet this keeps to the side the normal shows.
     */
    public boolean closest(
            double x,
            double y,
            double z,
            double maximumDistance,
            double nx,
            double ny,
            double nz,
            double minimumCosine,
            Hit out) {
        return search(x, y, z, maximumDistance * maximumDistance, nx, ny, nz, minimumCosine, true, out);
    }

    /**
     * Whether a point of the surface lies within {@code distance} mm: what {@link #closest(double, double, double,
     * double, Hit)} says, but the first triangle found so near is enough. It is looked for first where it was found the
     * last time.
     *
     * @param working its place is gone on from; holds no answer
     */
    public boolean isWithin(double x, double y, double z, double distance, Hit working) {
        double limit = distance * distance;
        if (working.leafPlace < order.length && squaredDistance(working.leafPlace, x, y, z, working.weights) <= limit) {
            return true;
        }
        int[] stack = working.stack;
        int depth = 0;
        int node = nodes > 0 && boxDistance(0, x, y, z) <= limit ? 0 : -1;
        while (node >= 0) {
            if (child[node] < 0) {
                int first = -1 - child[node];
                for (int place = first; place < first + count[node]; place++) {
                    if (squaredDistance(place, x, y, z, working.weights) <= limit) {
                        working.leafPlace = place;
                        return true;
                    }
                }
                node = depth > 0 ? stack[--depth] : -1;
            } else {
                int near = node + 1;
                int far = child[node];
                double nearDistance = boxDistance(near, x, y, z);
                double farDistance = boxDistance(far, x, y, z);
                if (farDistance < nearDistance) {
                    int swap = near;
                    near = far;
                    far = swap;
                    double swapDistance = nearDistance;
                    nearDistance = farDistance;
                    farDistance = swapDistance;
                }
                if (farDistance <= limit) {
                    stack[depth++] = far;
                }
                node = nearDistance <= limit ? near : depth > 0 ? stack[--depth] : -1;
            }
        }
        return false;
    }

    /** Squared distance of a point from one triangle; the weights of its nearest place come with it. */
    private double squaredDistance(int place, double x, double y, double z, double[] weights) {
        return flat[place]
                ? PointTriangleDistance.squaredDistanceToDegenerate(corners, 9 * place, x, y, z, weights)
                : PointTriangleDistance.squaredDistance(corners, 9 * place, x, y, z, weights);
    }

    private boolean search(
            double x,
            double y,
            double z,
            double limit,
            double nx,
            double ny,
            double nz,
            double minimumCosine,
            boolean filtered,
            Hit out) {
        out.triangle = -1;
        out.distanceSquared = Double.POSITIVE_INFINITY;
        // One step above the limit, so that a point exactly at the maximum distance is found.
        double best = Math.nextUp(limit);
        int[] stack = out.stack;
        double[] stackDistance = out.stackDistance;
        double[] weights = out.weights;
        int depth = 0;
        int node = nodes > 0 ? 0 : -1;
        double v = 0;
        double w = 0;
        int found = -1;
        while (node >= 0) {
            if (child[node] < 0) {
                int first = -1 - child[node];
                for (int place = first; place < first + count[node]; place++) {
                    if (filtered
                            && !(normals[3 * place] * nx + normals[3 * place + 1] * ny + normals[3 * place + 2] * nz
                                    > minimumCosine)) {
                        continue;
                    }
                    double square = squaredDistance(place, x, y, z, weights);
                    // Among equals the lowest triangle wins, so the answer does not depend on the tree's shape.
                    if (square < best || (square == best && found >= 0 && order[place] < order[found])) {
                        best = square;
                        found = place;
                        v = weights[0];
                        w = weights[1];
                    }
                }
                node = -1;
            } else {
                int near = node + 1;
                int far = child[node];
                double nearDistance = boxDistance(near, x, y, z);
                double farDistance = boxDistance(far, x, y, z);
                if (farDistance < nearDistance) {
                    int swap = near;
                    near = far;
                    far = swap;
                    double swapDistance = nearDistance;
                    nearDistance = farDistance;
                    farDistance = swapDistance;
                }
                if (farDistance <= best) {
                    stack[depth] = far;
                    stackDistance[depth++] = farDistance;
                }
                node = nearDistance <= best ? near : -1;
            }
            while (node < 0 && depth > 0) {
                depth--;
                if (stackDistance[depth] <= best) {
                    node = stack[depth];
                }
            }
        }
        if (found < 0) {
            return false;
        }
        answer(out, found, v, w);
        out.distanceSquared = best;
        return true;
    }

    private void answer(Hit out, int place, double v, double w) {
        int o = 9 * place;
        double u = 1 - v - w;
        out.leafPlace = place;
        out.triangle = order[place];
        out.weightA = u;
        out.weightB = v;
        out.weightC = w;
        out.x = u * corners[o] + v * corners[o + 3] + w * corners[o + 6];
        out.y = u * corners[o + 1] + v * corners[o + 4] + w * corners[o + 7];
        out.z = u * corners[o + 2] + v * corners[o + 5] + w * corners[o + 8];
    }

    private double boxDistance(int node, double x, double y, double z) {
        return BoundingBoxes.squaredDistance(boxes, 6 * node, x, y, z);
    }

    /**
     * The first triangle that the ray from (ox, oy, oz) along (dx, dy, dz) meets, from either side (Moeller and
     * Trumbore 1997, doi 10.1080/10867651.1997.10487468); false if none. {@code out.along} counts in lengths of the
     * direction.
     */
    public boolean nearestAlongRay(double ox, double oy, double oz, double dx, double dy, double dz, Hit out) {
        out.triangle = -1;
        out.rayParameter = Double.POSITIVE_INFINITY;
        out.distanceSquared = Double.POSITIVE_INFINITY;
        RayTraversal.traverse(this, ox, oy, oz, dx, dy, dz, out, false);
        if (out.triangle < 0) {
            return false;
        }
        answer(out, out.leafPlace, out.weightB, out.weightC);
        out.distanceSquared = out.rayParameter * out.rayParameter * (dx * dx + dy * dy + dz * dz);
        return true;
    }

    /**
     * How many triangles the ray meets. A ray through an edge may count both its triangles: for inside or outside ask
     * {@link #isInside}.
     */
    public int countAlongRay(double ox, double oy, double oz, double dx, double dy, double dz, Hit working) {
        working.rayParameter = Double.POSITIVE_INFINITY;
        return RayTraversal.traverse(this, ox, oy, oz, dx, dy, dz, working, true);
    }

    /**
     * Generalized winding number at (x, y, z): the sum of the triangles' solid angles over 4 pi, exact, over all
     * triangles (Jacobson et al. 2013, doi 10.1145/2461912.2461916; solid angle after Van Oosterom and Strackee 1983).
     * 1 inside and 0 outside a closed surface that faces outward; in between near the holes of an open one.
     */
    public double windingNumber(double x, double y, double z) {
        double sum = 0;
        for (int o = 0; o < corners.length; o += 9) {
            double ax = corners[o] - x;
            double ay = corners[o + 1] - y;
            double az = corners[o + 2] - z;
            double bx = corners[o + 3] - x;
            double by = corners[o + 4] - y;
            double bz = corners[o + 5] - z;
            double cx = corners[o + 6] - x;
            double cy = corners[o + 7] - y;
            double cz = corners[o + 8] - z;
            double a = Math.sqrt(ax * ax + ay * ay + az * az);
            double b = Math.sqrt(bx * bx + by * by + bz * bz);
            double c = Math.sqrt(cx * cx + cy * cy + cz * cz);
            double determinant = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
            double divisor = a * b * c
                    + (ax * bx + ay * by + az * bz) * c
                    + (bx * cx + by * cy + bz * cz) * a
                    + (cx * ax + cy * ay + cz * az) * b;
            sum += StrictMath.atan2(determinant, divisor);
        }
        return sum / (2 * Math.PI);
    }

    /**
     * Whether (x, y, z) lies inside the closed surface: the winding number rounds to other than 0. Points beyond the
     * bounding box are answered at once. The cost is one pass over all triangles.
     */
    public boolean isInside(double x, double y, double z) {
        return nodes > 0 && boxDistance(0, x, y, z) == 0 && Math.abs(windingNumber(x, y, z)) > 0.5;
    }
}
