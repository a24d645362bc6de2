package org.phrenic.mesh.query;

import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;

/**
 * Nearest-point, ray and inside-outside queries of a surface with a bounding volume hierarchy ({@link TriangleBoxes}).
 *
 * <p>Queries allocate nothing and may run on several threads, each with its own {@link Hit}. {@link #refit} must not
 * run concurrently with queries.
 */
public final class TriangleTree extends TriangleBoxes {
    private static final int NONE = -1;
    /**
     * Factor on the squared distance up to which boxes are searched, so that no triangle is left out because the
     * distance of its box is rounded up.
     */
    private static final double BOX_ROUNDING = 1 + 1e-12;
    /** Triangles of a subtree whose tests cost less than those of its boxes, where a bound is known. */
    private static final int FEW = 8;

    /** Result and working memory of a query; reuse one per thread. */
    public static final class Hit {
        /** Triangle found, -1 if none. */
        public int triangle = -1;
        /** Barycentric weights of the triangle's three corners; they sum to 1. */
        public double weightA;

        public double weightB;
        public double weightC;
        /** Nearest point or ray intersection, mm. */
        public double x;

        public double y;
        public double z;
        /** Squared distance to the query point, mm^2; infinite if nothing was found. */
        public double distanceSquared = Double.POSITIVE_INFINITY;
        /** For a ray, the distance to the triangle in lengths of the direction. */
        public double rayParameter = Double.POSITIVE_INFINITY;

        /** Stack of nodes still to be searched, with their squared distances. */
        final int[] stack = new int[64];

        final double[] stackDistance = new double[64];
        int depth;
        /** Weights of the second and third corner at the nearest point of the last tested triangle. */
        final double[] weights = new double[2];
        /** Index of the found triangle in leaf order. */
        int leafPlace;

        final double[] origin = new double[3];
        /** Direction of the ray, or reference normal for {@code leastCosine} if that is not NaN. */
        final double[] direction = new double[3];

        double leastCosine;

        private void start(double px, double py, double pz, double dx, double dy, double dz) {
            origin[0] = px;
            origin[1] = py;
            origin[2] = pz;
            direction[0] = dx;
            direction[1] = dy;
            direction[2] = dz;
            triangle = NONE;
            distanceSquared = Double.POSITIVE_INFINITY;
            rayParameter = Double.POSITIVE_INFINITY;
            depth = 0;
        }
    }

    public TriangleTree(TriangleMesh mesh) {
        super(mesh);
    }

    /** Finds the point of the surface nearest to (x, y, z). True if the mesh has a triangle. */
    public boolean closest(double x, double y, double z, Hit out) {
        return closest(x, y, z, Double.POSITIVE_INFINITY, out);
    }

    /** Finds the nearest point within {@code maximumDistance} mm; false if there is none. */
    public boolean closest(double x, double y, double z, double maximumDistance, Hit out) {
        return closest(x, y, z, maximumDistance, 0, 0, 0, Double.NaN, out);
    }

    /**
     * Finds the nearest point within a distance on triangles whose unit normal n satisfies n . (nx, ny, nz) &gt;
     * {@code minimumCosine}. On a thin sheet this excludes the opposite side.
     *
     * @param minimumCosine NaN for all triangles
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
        measure();
        out.start(x, y, z, nx, ny, nz);
        out.leastCosine = minimumCosine;
        return search(nodes > 0 ? 0 : NONE, squaredLimit(maximumDistance), 1, 0, null, out);
    }

    /** One unit in the last place above the square, so that a point at exactly the maximum distance is found. */
    private static double squaredLimit(double maximumDistance) {
        return Math.nextUp(maximumDistance * maximumDistance);
    }

    /**
     * Searches a subtree for a triangle nearer than a squared distance and writes the answer.
     *
     * @param rounding factor on the squared distance up to which boxes are searched
     * @param few number of triangles of a subtree up to which all are tested
     */
    private boolean search(int from, double limit, double rounding, int few, boolean[] among, Hit out) {
        double best = limit;
        int node = from;
        while (node >= 0) {
            if (child[node] < 0 || count[node] <= few) {
                best = closestInLeaf(first[node], count[node], best, among, out);
                node = pop(best * rounding, out);
            } else {
                node = descend(node, best * rounding, out);
            }
        }
        if (out.triangle < 0) {
            return false;
        }
        answer(out, out.leafPlace, out.weightB, out.weightC);
        out.distanceSquared = best;
        return true;
    }

    /**
     * Finds the nearest point within a distance among some triangles, beginning at a triangle that may be the nearest.
     * The answer is the same whatever the guess; a good one, such as the answer for a point that has moved little,
     * saves most of the search.
     *
     * @param guess triangle index; -1 for none
     * @param among whether each triangle counts; null for all
     */
    public boolean closest(double x, double y, double z, double maximumDistance, int guess, boolean[] among, Hit out) {
        measure();
        out.start(x, y, z, 0, 0, 0);
        out.leastCosine = Double.NaN;
        double best = squaredLimit(maximumDistance);
        if (guess >= 0 && (among == null || among[guess])) {
            best = closestInLeaf(placeOf(guess), 1, best, among, out);
        }
        return search(nodes > 0 && boxDistance(0, out) <= best ? 0 : NONE, best, BOX_ROUNDING, FEW, among, out);
    }

    /**
     * Squared distance from (x, y, z) to one triangle, mm^2.
     *
     * @param working working memory; its result fields are not set
     */
    public double squaredDistance(int triangle, double x, double y, double z, Hit working) {
        measure();
        return squaredDistance(placeOf(triangle), x, y, z, working.weights);
    }

    /**
     * Distance of each point from the surface, mm; infinite if the mesh has no triangle. Points are three numbers each.
     */
    public double[] distances(double[] points) {
        Hit hit = new Hit();
        double[] distances = new double[points.length / 3];
        for (int i = 0; i < distances.length; i++) {
            closest(points[3 * i], points[3 * i + 1], points[3 * i + 2], hit);
            distances[i] = Math.sqrt(hit.distanceSquared);
        }
        return distances;
    }

    /** Searches triangles of a leaf for a nearer one; returns the updated least squared distance. */
    private double closestInLeaf(int from, int triangles, double limit, boolean[] among, Hit out) {
        double best = limit;
        double x = out.origin[0];
        double y = out.origin[1];
        double z = out.origin[2];
        for (int place = from; place < from + triangles; place++) {
            if ((among != null && !among[order[place]])
                    || discs.isFarther(place, x, y, z, best)
                    || (!Double.isNaN(out.leastCosine) && !faces(place, out))) {
                continue;
            }
            double square = squaredDistance(place, x, y, z, out.weights);
            // Equal distances are resolved by the lowest triangle index, so the answer does not depend on the tree.
            if (square < best || (square == best && out.triangle >= 0 && order[place] < out.triangle)) {
                best = square;
                out.leafPlace = place;
                out.triangle = order[place];
                out.weightB = out.weights[0];
                out.weightC = out.weights[1];
            }
        }
        return best;
    }

    private boolean faces(int place, Hit out) {
        double[] n = out.direction;
        return normals[3 * place] * n[0] + normals[3 * place + 1] * n[1] + normals[3 * place + 2] * n[2]
                > out.leastCosine;
    }

    /**
     * The nearer child of a node, or the next node on the stack. The farther child is pushed if it is within the limit.
     */
    private int descend(int node, double limit, Hit out) {
        int near = node + 1;
        int far = child[node];
        double nearDistance = boxDistance(near, out);
        double farDistance = boxDistance(far, out);
        if (farDistance < nearDistance) {
            int swap = near;
            near = far;
            far = swap;
            double swapDistance = nearDistance;
            nearDistance = farDistance;
            farDistance = swapDistance;
        }
        if (farDistance <= limit) {
            out.stack[out.depth] = far;
            out.stackDistance[out.depth++] = farDistance;
        }
        return nearDistance <= limit ? near : pop(limit, out);
    }

    /** The next node on the stack within a squared distance; {@link #NONE} if there is none. */
    private static int pop(double limit, Hit out) {
        while (out.depth > 0) {
            out.depth--;
            if (out.stackDistance[out.depth] <= limit) {
                return out.stack[out.depth];
            }
        }
        return NONE;
    }

    /**
     * Whether a point of the surface is within {@code distance} mm. Stops at the first such triangle; the one found by
     * the previous query is tested first.
     *
     * @param working working memory kept between queries; its result fields are not set
     */
    public boolean isWithin(double x, double y, double z, double distance, Hit working) {
        measure();
        double limit = distance * distance;
        if (working.leafPlace < order.length && squaredDistance(working.leafPlace, x, y, z, working.weights) <= limit) {
            return true;
        }
        working.start(x, y, z, 0, 0, 0);
        int node = nodes > 0 && boxDistance(0, working) <= limit ? 0 : NONE;
        while (node >= 0) {
            if (child[node] >= 0) {
                node = descend(node, limit, working);
                continue;
            }
            for (int place = first[node]; place < first[node] + count[node]; place++) {
                if (!discs.isFarther(place, x, y, z, limit)
                        && squaredDistance(place, x, y, z, working.weights) <= limit) {
                    working.leafPlace = place;
                    return true;
                }
            }
            node = pop(limit, working);
        }
        return false;
    }

    /** Squared distance from a point to one triangle. Also writes the weights of the nearest point. */
    private double squaredDistance(int place, double x, double y, double z, double[] weights) {
        return flat[place]
                ? PointTriangleDistance.squaredDistanceToDegenerate(corners, 9 * place, x, y, z, weights)
                : PointTriangleDistance.squaredDistance(corners, 9 * place, x, y, z, weights);
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

    private double boxDistance(int node, Hit query) {
        double[] p = query.origin;
        return BoundingBoxes.squaredDistance(boxes, 6 * node, p[0], p[1], p[2]);
    }

    /**
     * Finds the first intersection of the ray from (ox, oy, oz) along (dx, dy, dz), from either side of a triangle
     * (Moeller and Trumbore 1997, doi 10.1080/10867651.1997.10487468); false if none. {@code out.rayParameter} is in
     * lengths of the direction.
     */
    public boolean nearestAlongRay(double ox, double oy, double oz, double dx, double dy, double dz, Hit out) {
        out.start(ox, oy, oz, dx, dy, dz);
        RayTraversal.traverse(this, out, false);
        if (out.triangle < 0) {
            return false;
        }
        answer(out, out.leafPlace, out.weightB, out.weightC);
        out.distanceSquared = out.rayParameter * out.rayParameter * (dx * dx + dy * dy + dz * dz);
        return true;
    }

    /**
     * Number of triangles that the ray intersects. A ray through an edge may count both its triangles; use
     * {@link #isInside} for inside-outside tests.
     */
    public int countAlongRay(double ox, double oy, double oz, double dx, double dy, double dz, Hit working) {
        working.start(ox, oy, oz, dx, dy, dz);
        return RayTraversal.traverse(this, working, true);
    }

    /**
     * Generalized winding number at (x, y, z): the sum of the solid angles of all triangles over 4 pi, exact (Jacobson
     * et al. 2013, doi 10.1145/2461912.2461916). It is 1 inside and 0 outside a closed surface that faces outward, and
     * takes values in between near the holes of an open surface.
     */
    public double windingNumber(double x, double y, double z) {
        return SolidAngles.sum(corners, x, y, z) / (2 * Math.PI);
    }

    /**
     * Whether (x, y, z) is inside the closed surface: the rounded winding number is not 0. Points outside the bounding
     * box return at once; otherwise the cost is one pass over all triangles.
     */
    public boolean isInside(double x, double y, double z) {
        return nodes > 0
                && BoundingBoxes.squaredDistance(boxes, 0, x, y, z) == 0
                && Math.abs(windingNumber(x, y, z)) > 0.5;
    }
}
