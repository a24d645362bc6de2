package org.phrenic.mesh.query;

import org.phrenic.mesh.BoundingBoxes;

/**
 * Ray traversal of the boxes and triangles of a {@link TriangleTree} (Moeller and Trumbore 1997, doi
 * 10.1080/10867651.1997.10487468). Allocates nothing.
 */
final class RayTraversal {
    private static final double RELATIVE_SLACK = 1e-12;

    private RayTraversal() {}

    /**
     * Traces the ray stored in a hit.
     *
     * @param out its {@code rayParameter} limits the ray, in lengths of the direction; receives the first triangle hit
     *     unless {@code counting}
     * @param counting whether to count all triangles along the ray
     * @return number of triangles hit; if not counting, how often a nearer one was found
     */
    static int traverse(TriangleTree tree, TriangleTree.Hit out, boolean counting) {
        int[] stack = out.stack;
        int depth = 0;
        int met = 0;
        if (tree.nodes > 0) {
            stack[depth++] = 0;
        }
        while (depth > 0) {
            int node = stack[--depth];
            // The padding covers rounding of the quotients, so that the triangle in a flat box is not missed.
            if (!BoundingBoxes.meetsRay(
                    tree.boxes, 6 * node, out.origin, out.direction, out.rayParameter, 0, RELATIVE_SLACK)) {
                continue;
            }
            if (tree.child[node] >= 0) {
                stack[depth++] = tree.child[node];
                stack[depth++] = node + 1;
                continue;
            }
            int first = tree.first[node];
            for (int place = first; place < first + tree.count[node]; place++) {
                double along = intersectTriangle(tree, place, out);
                if (along == Double.POSITIVE_INFINITY) {
                    continue;
                }
                if (counting) {
                    met++;
                } else if (along < out.rayParameter
                        || (along == out.rayParameter && tree.order[place] < out.triangle)) {
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

    /**
     * The ray parameter at the intersection with a triangle, infinite if there is none. Also sets the barycentric
     * weights of the second and third corner.
     */
    private static double intersectTriangle(TriangleTree tree, int place, TriangleTree.Hit out) {
        double[] corners = tree.corners;
        double[] origin = out.origin;
        double dx = out.direction[0];
        double dy = out.direction[1];
        double dz = out.direction[2];
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
        double tx = origin[0] - corners[o];
        double ty = origin[1] - corners[o + 1];
        double tz = origin[2] - corners[o + 2];
        double v = (tx * px + ty * py + tz * pz) / determinant;
        double qx = ty * e1z - tz * e1y;
        double qy = tz * e1x - tx * e1z;
        double qz = tx * e1y - ty * e1x;
        double w = (dx * qx + dy * qy + dz * qz) / determinant;
        double along = (e2x * qx + e2y * qy + e2z * qz) / determinant;
        if (!(v >= 0 && w >= 0 && v + w <= 1 && along >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        out.weights[0] = v;
        out.weights[1] = w;
        return along;
    }
}
