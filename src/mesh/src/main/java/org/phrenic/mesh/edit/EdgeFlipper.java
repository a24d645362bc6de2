package org.phrenic.mesh.edit;

import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.Vectors;

/**
 * Flips edges until the surface is Delaunay. An edge whose opposite angles sum to more than 180 degrees is replaced by
 * the other diagonal. A flip is rejected if it folds the surface, or if the new edge bends by more than 30 degrees and
 * more sharply than the old edge.
 */
final class EdgeFlipper {
    private static final int MAX_PASSES = 5;
    /** An edge whose triangle normals have a cosine below this (100 degrees) is not flipped. */
    private static final double RIM = -0.17;
    /** Bends below 30 degrees count as flat. */
    private static final double FLAT_ENOUGH = 0.87;

    private final HalfEdgeMesh mesh;
    private final double[] first = new double[3];
    private final double[] second = new double[3];
    private final double[] third = new double[3];
    private final double[] fourth = new double[3];

    EdgeFlipper(HalfEdgeMesh mesh) {
        this.mesh = mesh;
    }

    int flipAll() {
        int total = 0;
        for (int pass = 0; pass < MAX_PASSES; pass++) {
            int flipped = 0;
            for (int h = 0; h < 3 * mesh.triangleEnd; h++) {
                if (!mesh.flipChecked[h]) {
                    flipped += settle(h);
                }
            }
            total += flipped;
            // Another pass is not worthwhile for fewer than one flip per 1,000 vertices.
            if (flipped * 1000 < mesh.vertexCount()) {
                break;
            }
        }
        return total;
    }

    /** Flips the edge or marks it as checked; returns the number of flips. */
    private int settle(int h) {
        if (mesh.twin[h] == HalfEdgeMesh.NONE || !mesh.isPrimary(h) || mesh.crease[h] || !wouldGain(h)) {
            mesh.flipChecked[h] = true;
            return 0;
        }
        if (!mayFlip(h)) {
            // The neighbouring topology does not allow the flip. The next pass checks it again.
            return 0;
        }
        mesh.flip(h);
        return 1;
    }

    /** Whether the flip improves the two triangles, judged by their four corners only. */
    private boolean wouldGain(int h) {
        int o = mesh.twin[h];
        int a = mesh.start[h];
        int b = mesh.start[o];
        int c = mesh.start[HalfEdgeMesh.previous(h)];
        int d = mesh.start[HalfEdgeMesh.previous(o)];
        // Delaunay test sin(angle at c + angle at d) < 0, computed without trigonometric functions.
        double cosC = dotAt(c, a, b);
        double cosD = dotAt(d, a, b);
        if (cosC > 0 && cosD > 0) {
            return false;
        }
        double areaC = normal(a, b, c, first);
        double areaD = normal(b, a, d, second);
        if (areaC * cosD + cosC * areaD >= -1e-9 * (Math.abs(areaC * cosD) + Math.abs(cosC * areaD))) {
            return false;
        }
        double areaA = normal(a, d, c, third);
        double areaB = normal(d, b, c, fourth);
        if (!(areaA > 0 && areaB > 0)) {
            return false;
        }
        double bendAfter = Vectors.dot(third, fourth) / (areaA * areaB);
        if (areaC > 0 && areaD > 0) {
            double bendBefore = Vectors.dot(first, second) / (areaC * areaD);
            if (bendBefore < RIM || bendAfter < Math.min(FLAT_ENOUGH, bendBefore)) {
                return false;
            }
        } else if (bendAfter < FLAT_ENOUGH) {
            return false;
        }
        double sx = first[0] + second[0];
        double sy = first[1] + second[1];
        double sz = first[2] + second[2];
        return third[0] * sx + third[1] * sy + third[2] * sz > 0
                && fourth[0] * sx + fourth[1] * sy + fourth[2] * sz > 0;
    }

    /** Whether the flip keeps the least valence at both ends and the new edge does not exist yet. */
    private boolean mayFlip(int h) {
        int o = mesh.twin[h];
        int a = mesh.start[h];
        int b = mesh.start[o];
        int leastA = mesh.isBoundaryVertex(a) ? 2 : 3;
        int leastB = mesh.isBoundaryVertex(b) ? 2 : 3;
        return mesh.valenceExceeds(leastA, a)
                && mesh.valenceExceeds(leastB, b)
                && !mesh.areNeighbours(mesh.start[HalfEdgeMesh.previous(h)], mesh.start[HalfEdgeMesh.previous(o)]);
    }

    private double dotAt(int at, int a, int b) {
        double[] p = mesh.position;
        double x = p[3 * at];
        double y = p[3 * at + 1];
        double z = p[3 * at + 2];
        return (p[3 * a] - x) * (p[3 * b] - x)
                + (p[3 * a + 1] - y) * (p[3 * b + 1] - y)
                + (p[3 * a + 2] - z) * (p[3 * b + 2] - z);
    }

    private double normal(int a, int b, int c, double[] n) {
        return Triangles.cross(mesh.position, 3 * a, 3 * b, 3 * c, n);
    }
}
