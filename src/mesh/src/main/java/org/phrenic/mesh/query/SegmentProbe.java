package org.phrenic.mesh.query;

import java.util.Arrays;
import org.phrenic.mesh.BoundingBoxes;

/**
 * Intersections of a straight segment with surfaces, and the distance between them.
 *
 * <p>The intersection test is that of Woop, Benthin and Wald 2013 (JCGT 2:65). Corners are sheared so that the segment
 * runs along an axis through 0. The signs of the three edge determinants show whether 0 is inside the triangle. The
 * signs are exact for the sheared corners. A zero determinant is resolved by an infinitesimal shift of the segment
 * (Edelsbrunner and Muecke 1990, doi 10.1145/77635.77639), so two triangles always agree on their shared edge. A
 * segment through an edge or a corner of a closed surface therefore crosses once, and entries and exits come in pairs.
 *
 * <p>An instance holds working memory: use one per thread and reuse it. Queries may run concurrently on several
 * threads, but not concurrently with {@link TriangleTree#refit}.
 */
public final class SegmentProbe {
    private static final double BOX_SLACK_MM = 1e-7;
    private static final int STACK = 64;
    /** Far more than the rounding of a squared distance, relative to it and in mm^2. */
    private static final double ROUNDING = 1e-8;

    private final double[] from = new double[3];
    private final double[] to = new double[3];
    private final double[] unit = new double[3];
    private double length;
    private int kx;
    private int ky;
    private int kz;
    private double shearX;
    private double shearY;
    private double scaleZ;
    /** Least squared distance from the line of the segment over the square of a sheared coordinate. */
    private double nearX;

    private double nearY;

    private int found;
    private double[] depths = new double[STACK];
    private int[] facings = new int[STACK];
    private int[] triangles = new int[STACK];
    private final double[] sheared = new double[9];
    private final int[] stack = new int[STACK];
    private final double[] bounds = new double[STACK];
    private final double[] weights = new double[2];
    private double nearestDepth;
    private double depthOfPair;

    /** Sets the end points of the segment, mm. */
    public void set(double fx, double fy, double fz, double tx, double ty, double tz) {
        from[0] = fx;
        from[1] = fy;
        from[2] = fz;
        to[0] = tx;
        to[1] = ty;
        to[2] = tz;
        length = Math.sqrt((tx - fx) * (tx - fx) + (ty - fy) * (ty - fy) + (tz - fz) * (tz - fz));
        for (int axis = 0; axis < 3; axis++) {
            unit[axis] = length > 0 ? (to[axis] - from[axis]) / length : axis == 2 ? 1 : 0;
        }
        kz = Math.abs(unit[0]) > Math.abs(unit[1]) ? 0 : 1;
        kz = Math.abs(unit[2]) > Math.abs(unit[kz]) ? 2 : kz;
        kx = (kz + 1) % 3;
        ky = (kx + 1) % 3;
        if (unit[kz] < 0) {
            int swap = kx;
            kx = ky;
            ky = swap;
        }
        shearX = unit[kx] / unit[kz];
        shearY = unit[ky] / unit[kz];
        scaleZ = 1 / unit[kz];
        double square = unit[kz] * unit[kz];
        nearX = square / (square + unit[kx] * unit[kx]);
        nearY = square / (square + unit[ky] * unit[ky]);
    }

    /** Length of the segment, mm. */
    public double length() {
        return length;
    }

    /** Finds all intersections with a surface, in order of depth; returns their number. */
    public int intersect(TriangleTree tree) {
        found = 0;
        int depth = 0;
        if (tree.nodes > 0) {
            stack[depth++] = 0;
        }
        while (depth > 0) {
            int node = stack[--depth];
            if (!BoundingBoxes.meetsRay(tree.boxes, 6 * node, from, unit, length, BOX_SLACK_MM, 0)) {
                continue;
            }
            if (tree.child[node] >= 0) {
                stack[depth++] = tree.child[node];
                stack[depth++] = node + 1;
                continue;
            }
            int first = tree.first[node];
            for (int place = first; place < first + tree.count[node]; place++) {
                shear(tree.corners, 9 * place);
                int facing = pierces();
                if (facing != 0) {
                    add(depthOfPair, facing, tree.order[place]);
                }
            }
        }
        return found;
    }

    /** Depth of the i-th intersection from the start of the segment, mm. */
    public double depth(int i) {
        return depths[i];
    }

    /** 1 if the segment enters the surface at the i-th intersection (against the outward normal), -1 if it leaves. */
    public int facing(int i) {
        return facings[i];
    }

    /** Triangle of the i-th intersection. */
    public int triangle(int i) {
        return triangles[i];
    }

    private void add(double depth, int facing, int triangle) {
        if (found == depths.length) {
            depths = Arrays.copyOf(depths, 2 * found);
            facings = Arrays.copyOf(facings, 2 * found);
            triangles = Arrays.copyOf(triangles, 2 * found);
        }
        int i = found++;
        // Equal depths are ordered by triangle index, so the order does not depend on the tree.
        while (i > 0 && (depths[i - 1] > depth || (depths[i - 1] == depth && triangles[i - 1] > triangle))) {
            depths[i] = depths[i - 1];
            facings[i] = facings[i - 1];
            triangles[i] = triangles[i - 1];
            i--;
        }
        depths[i] = depth;
        facings[i] = facing;
        triangles[i] = triangle;
    }

    private void shear(double[] corners, int o) {
        for (int k = 0; k < 9; k += 3) {
            double z = corners[o + k + kz] - from[kz];
            sheared[k] = corners[o + k + kx] - from[kx] - shearX * z;
            sheared[k + 1] = corners[o + k + ky] - from[ky] - shearY * z;
            sheared[k + 2] = scaleZ * z;
        }
    }

    /**
     * 1 if the segment enters through the sheared triangle, -1 if it leaves, 0 if it misses. Sets {@code depthOfPair}.
     */
    private int pierces() {
        int u = side(3, 6);
        if (side(6, 0) != u || side(0, 3) != u) {
            return 0;
        }
        double a = sheared[3] * sheared[7] - sheared[4] * sheared[6];
        double b = sheared[6] * sheared[1] - sheared[7] * sheared[0];
        double c = sheared[0] * sheared[4] - sheared[1] * sheared[3];
        double sum = a + b + c;
        double depth = sum == 0
                ? (sheared[2] + sheared[5] + sheared[8]) / 3
                : (a * sheared[2] + b * sheared[5] + c * sheared[8]) / sum;
        if (!(depth >= 0 && depth <= length)) {
            return 0;
        }
        depthOfPair = depth;
        return -u;
    }

    /** Exact sign of the determinant of two sheared corners; never 0. */
    private int side(int p, int q) {
        double px = sheared[p];
        double py = sheared[p + 1];
        double qx = sheared[q];
        double qy = sheared[q + 1];
        double left = px * qy;
        double right = py * qx;
        if (left != right) {
            return left > right ? 1 : -1;
        }
        double rest = Math.fma(px, qy, -left) - Math.fma(py, qx, -right);
        if (rest != 0) {
            return rest > 0 ? 1 : -1;
        }
        // The segment meets the edge: it is shifted by (e, e²) with an infinitesimal e.
        if (qy != py) {
            return qy < py ? 1 : -1;
        }
        return qx > px ? 1 : -1;
    }

    /**
     * Smallest distance between the segment and a surface, mm; 0 if they intersect. See {@link #nearestDepth}.
     *
     * @param limit upper bound of the result, mm; a smaller limit makes the query faster
     */
    public double distance(TriangleTree tree, double limit) {
        nearestDepth = Double.NaN;
        double best = limit * limit;
        int depth = 0;
        if (tree.nodes > 0) {
            stack[0] = 0;
            bounds[depth++] = boxBound(tree.boxes, 0);
        }
        while (depth > 0) {
            int node = stack[--depth];
            if (bounds[depth] >= best) {
                continue;
            }
            if (tree.child[node] >= 0) {
                int near = node + 1;
                int far = tree.child[node];
                double nearBound = boxBound(tree.boxes, 6 * near);
                double farBound = boxBound(tree.boxes, 6 * far);
                boolean swap = farBound < nearBound;
                stack[depth] = swap ? near : far;
                bounds[depth++] = swap ? nearBound : farBound;
                stack[depth] = swap ? far : near;
                bounds[depth++] = swap ? farBound : nearBound;
                continue;
            }
            int first = tree.first[node];
            for (int place = first; place < first + tree.count[node]; place++) {
                double square = toTriangle(tree.corners, 9 * place, best);
                if (square < best) {
                    best = square;
                    nearestDepth = depthOfPair;
                }
            }
        }
        return Double.isNaN(nearestDepth) ? limit : Math.sqrt(best);
    }

    /**
     * Depth along the segment of its nearest point in the last {@link #distance} query, mm; NaN if the surface is
     * beyond the limit.
     */
    public double nearestDepth() {
        return nearestDepth;
    }

    /**
     * Lower bound of the squared distance to a box: the larger of the bounds from its bounding sphere and from the box
     * of the segment.
     */
    private double boxBound(double[] boxes, int o) {
        double along = 0;
        double apart = 0;
        double radius = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes[o + axis];
            double high = boxes[o + 3 + axis];
            along += (0.5 * (low + high) - from[axis]) * unit[axis];
            radius += 0.25 * (high - low) * (high - low);
            double gap =
                    Math.max(0, Math.max(low - Math.max(from[axis], to[axis]), Math.min(from[axis], to[axis]) - high));
            apart += gap * gap;
        }
        along = Math.max(0, Math.min(length, along));
        double toMiddle = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = from[axis] + along * unit[axis] - 0.5 * (boxes[o + axis] + boxes[o + 3 + axis]);
            toMiddle += d * d;
        }
        double beyond = Math.sqrt(toMiddle) - Math.sqrt(radius) - BOX_SLACK_MM;
        return Math.max(beyond > 0 ? beyond * beyond : 0, apart * (1 - 1e-12));
    }

    /** Whether the sheared triangle is certainly farther from the line of the segment than a squared distance. */
    private boolean isFarther(double limit) {
        double x = leastSize(sheared[0], sheared[3], sheared[6]);
        double y = leastSize(sheared[1], sheared[4], sheared[7]);
        double within = limit + ROUNDING * (1 + limit);
        return x * x * nearX > within || y * y * nearY > within;
    }

    /** Least size of the numbers between three. */
    private static double leastSize(double a, double b, double c) {
        double low = a < b ? a : b;
        double high = a < b ? b : a;
        low = c < low ? c : low;
        high = c > high ? c : high;
        return low > 0 ? low : high < 0 ? -high : 0;
    }

    /**
     * Squared distance to a triangle, or infinite if it is certainly greater than a limit. Sets {@code depthOfPair} to
     * the depth of the nearest point.
     */
    private double toTriangle(double[] c, int o, double limit) {
        shear(c, o);
        if (isFarther(limit)) {
            return Double.POSITIVE_INFINITY;
        }
        if (pierces() != 0) {
            return 0;
        }
        double best = PointTriangleDistance.squaredDistance(c, o, from[0], from[1], from[2], weights);
        double at = 0;
        double square = PointTriangleDistance.squaredDistance(c, o, to[0], to[1], to[2], weights);
        if (square < best) {
            best = square;
            at = length;
        }
        for (int k = 0; k < 9; k += 3) {
            square = toEdge(c, o + k, o + (k + 3) % 9);
            if (square < best) {
                best = square;
                at = depthOfPair;
            }
        }
        depthOfPair = at;
        return best;
    }

    /** Squared distance to an edge (Ericson, Real-Time Collision Detection, 2005, section 5.1.9). */
    private double toEdge(double[] c, int a, int b) {
        double ex = c[b] - c[a];
        double ey = c[b + 1] - c[a + 1];
        double ez = c[b + 2] - c[a + 2];
        double rx = from[0] - c[a];
        double ry = from[1] - c[a + 1];
        double rz = from[2] - c[a + 2];
        double ee = ex * ex + ey * ey + ez * ez;
        double er = ex * rx + ey * ry + ez * rz;
        double ur = unit[0] * rx + unit[1] * ry + unit[2] * rz;
        double ue = unit[0] * ex + unit[1] * ey + unit[2] * ez;
        double divisor = ee - ue * ue;
        double s = divisor > 0 ? Math.max(0, Math.min(length, (ue * er - ur * ee) / divisor)) : 0;
        double t = ee > 0 ? (ue * s + er) / ee : 0;
        if (!(t >= 0 && t <= 1)) {
            t = t > 1 ? 1 : 0;
            s = Math.max(0, Math.min(length, t * ue - ur));
        }
        double dx = rx + s * unit[0] - t * ex;
        double dy = ry + s * unit[1] - t * ey;
        double dz = rz + s * unit[2] - t * ez;
        depthOfPair = s;
        return dx * dx + dy * dy + dz * dz;
    }
}
