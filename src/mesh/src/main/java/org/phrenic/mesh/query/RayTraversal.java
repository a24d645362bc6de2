package org.phrenic.mesh.query;

/**
 * A ray through the boxes and triangles of a {@link TriangleTree} (Moeller and Trumbore 1997, doi
 * 10.1080/10867651.1997.10487468). Allocates nothing.
 */
final class RayTraversal {
    private RayTraversal() {}

    /**
     * Goes through the boxes that the ray meets.
     *
     * @param out its {@code along} is as far as the ray goes, in lengths of the direction; receives the first triangle
     *     met unless {@code counting}
     * @param counting whether all triangles are counted that the ray meets on its way
     * @return how many were met; where not counting, how often a nearer one was found
     */
    static int traverse(
            TriangleTree tree,
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            TriangleTree.Hit out,
            boolean counting) {
        int[] stack = out.stack;
        int depth = 0;
        int met = 0;
        if (tree.nodes > 0) {
            stack[depth++] = 0;
        }
        while (depth > 0) {
            int node = stack[--depth];
            if (!intersectsBox(tree.boxes, node, ox, oy, oz, dx, dy, dz, out.rayParameter)) {
                continue;
            }
            if (tree.child[node] >= 0) {
                stack[depth++] = tree.child[node];
                stack[depth++] = node + 1;
                continue;
            }
            int first = -1 - tree.child[node];
            for (int place = first; place < first + tree.count[node]; place++) {
                double along = intersectTriangle(tree.corners, place, ox, oy, oz, dx, dy, dz, out.weights);
                if (along < Double.POSITIVE_INFINITY && counting) {
                    met++;
                } else if (along < out.rayParameter
                        || (along == out.rayParameter && met > 0 && tree.order[place] < out.triangle)) {
                    met++;
                    out.rayParameter = along;
                    out.triangle = tree.order[place];
                    out.leafPlace = place;
                    out.weightB = out.weights[0];
                    out.weightC = out.weights[1];
                }
            }
        }
        return met;
    }

    private static boolean intersectsBox(
            double[] boxes, int node, double ox, double oy, double oz, double dx, double dy, double dz, double limit) {
        int o = 6 * node;
        double from = 0;
        double to = limit;
        for (int axis = 0; axis < 3; axis++) {
            double origin = axis == 0 ? ox : axis == 1 ? oy : oz;
            double direction = axis == 0 ? dx : axis == 1 ? dy : dz;
            double low = boxes[o + axis] - origin;
            double high = boxes[o + 3 + axis] - origin;
            if (direction == 0) {
                if (low > 0 || high < 0) {
                    return false;
                }
                continue;
            }
            double t1 = low / direction;
            double t2 = high / direction;
            from = Math.max(from, Math.min(t1, t2));
            to = Math.min(to, Math.max(t1, t2));
        }
        // A little slack: the quotients round, and a flat box must not lose the triangle that lies in it.
        return from <= to + 1e-12 * Math.abs(to);
    }

    private static double intersectTriangle(
            double[] corners,
            int place,
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] weights) {
        int o = 9 * place;
        double e1x = corners[o + 3] - corners[o];
        double e1y = corners[o + 4] - corners[o + 1];
        double e1z = corners[o + 5] - corners[o + 2];
        double e2x = corners[o + 6] - corners[o];
        double e2y = corners[o + 7] - corners[o + 1];
        double e2z = corners[o + 8] - corners[o + 2];
        double px = dy * e2z - dz * e2y;
        double py = dz * e2x - dx * e2z;
        double pz = dx * e2y - dy * e2x;
        double determinant = e1x * px + e1y * py + e1z * pz;
        if (determinant == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double tx = ox - corners[o];
        double ty = oy - corners[o + 1];
        double tz = oz - corners[o + 2];
        double v = (tx * px + ty * py + tz * pz) / determinant;
        double qx = ty * e1z - tz * e1y;
        double qy = tz * e1x - tx * e1z;
        double qz = tx * e1y - ty * e1x;
        double w = (dx * qx + dy * qy + dz * qz) / determinant;
        double along = (e2x * qx + e2y * qy + e2z * qz) / determinant;
        if (!(v >= 0 && w >= 0 && v + w <= 1 && along >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        weights[0] = v;
        weights[1] = w;
        return along;
    }
}
