package org.phrenic.patient.registration;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Trimmed iterative closest points, point to plane: it moves points of the first scan into the place of the second,
 * whose tree then stays. Each round takes the {@value #INLIER_FRACTION} of the points that lie nearest to the surface
 * and forms the small turn r and shift t about their middle c after which sum w (n . (p + r x (p - c) + t - q))^2 is
 * least, q nearest to p and n the normal there.
 */
final class TrimmedIcp {
    static final double INLIER_FRACTION = 0.7;
    private static final int ROUNDS = 80;
    /** A point belongs only to a surface that looks the same way, within 60 degrees. */
    private static final double SAME_WAY = 0.5;
    /** Size of a body's parts, mm: by it turns are weighed against shifts. */
    private static final double ARM_MM = 100;

    private static final double DAMPING = 1e-6;

    private final TriangleMesh surface;
    private final TriangleTree tree;
    private final double[] surfaceNormals;
    private final double[] points;
    private final double[] normals;
    private final double[] weights;
    private final int count;
    private final double[] start;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    TrimmedIcp(TriangleMesh first, boolean[] fixed, TriangleMesh second) {
        surface = second;
        tree = new TriangleTree(second);
        surfaceNormals = MeshMeasure.triangleNormals(second);
        double[] areas = MeshMeasure.vertexAreas(first);
        double[] all = MeshMeasure.vertexNormals(first);
        points = new double[3 * first.vertexCount()];
        normals = new double[points.length];
        weights = new double[first.vertexCount()];
        int n = 0;
        for (int v = 0; v < fixed.length; v++) {
            if (fixed[v]) {
                System.arraycopy(first.positions(), 3 * v, points, 3 * n, 3);
                System.arraycopy(all, 3 * v, normals, 3 * n, 3);
                weights[n++] = areas[v];
            }
        }
        count = n;
        double[] a = first.bounds();
        double[] b = second.bounds();
        // Lungs differ in depth and at the base: tops and backs are laid together, and middles across.
        start = new double[] {(b[0] + b[3] - a[0] - a[3]) / 2, b[4] - a[4], b[5] - a[5]};
    }

    ScanAlignment align(ScanAlignment.FixedPart part, boolean centred) {
        double[] p = Arrays.copyOf(points, 3 * count);
        double[] n = Arrays.copyOf(normals, 3 * count);
        double[] original = p.clone();
        double[] originalNormals = n.clone();
        RigidMotion motion = centred ? centroidTranslation(p) : RigidMotion.translation(start[0], start[1], start[2]);
        double[] distance = new double[count];
        boolean[] kept = new boolean[count];
        double[] nearest = new double[3 * count];
        double[] planes = new double[3 * count];
        for (int round = 0; round <= ROUNDS; round++) {
            System.arraycopy(original, 0, p, 0, p.length);
            motion.apply(p);
            rotate(motion, originalNormals, n);
            findCorrespondences(p, n, nearest, planes, distance);
            trim(distance, kept);
            if (round < ROUNDS) {
                motion = gaussNewtonStep(p, nearest, planes, kept).after(motion);
            }
        }
        double[] w = Arrays.copyOf(weights, count);
        double[] finite = new double[count];
        double[] keptWeights = new double[count];
        for (int i = 0; i < count; i++) {
            tree.closest(p[3 * i], p[3 * i + 1], p[3 * i + 2], hit);
            finite[i] = Math.sqrt(hit.distanceSquared);
            keptWeights[i] = kept[i] ? w[i] : 0;
        }
        return new ScanAlignment(
                motion.inverse(), part, DistanceSummary.of(finite, w), DistanceSummary.of(finite, keptWeights));
    }

    private RigidMotion centroidTranslation(double[] p) {
        double[] shift = new double[3];
        for (int i = 0; i < p.length; i++) {
            shift[i % 3] -= p[i] / count;
        }
        for (int i = 0; i < surface.positions().length; i++) {
            shift[i % 3] += surface.positions()[i] / surface.vertexCount();
        }
        return RigidMotion.translation(shift[0], shift[1], shift[2]);
    }

    private static void rotate(RigidMotion motion, double[] from, double[] to) {
        for (int i = 0; i < from.length; i += 3) {
            for (int row = 0; row < 3; row++) {
                to[i + row] = motion.rotation(row, 0) * from[i]
                        + motion.rotation(row, 1) * from[i + 1]
                        + motion.rotation(row, 2) * from[i + 2];
            }
        }
    }

    /** Nearest points, their planes and distances; infinite where the nearest surface looks another way. */
    private void findCorrespondences(double[] p, double[] n, double[] nearest, double[] planes, double[] distance) {
        for (int i = 0; i < count; i++) {
            tree.closest(p[3 * i], p[3 * i + 1], p[3 * i + 2], hit);
            nearest[3 * i] = hit.x;
            nearest[3 * i + 1] = hit.y;
            nearest[3 * i + 2] = hit.z;
            double along = 0;
            for (int k = 0; k < 3; k++) {
                planes[3 * i + k] = surfaceNormals[3 * hit.triangle + k];
                along += planes[3 * i + k] * n[3 * i + k];
            }
            distance[i] = along > SAME_WAY ? Math.sqrt(hit.distanceSquared) : Double.POSITIVE_INFINITY;
        }
    }

    private static void trim(double[] distance, boolean[] kept) {
        double[] sorted = distance.clone();
        Arrays.sort(sorted);
        double bound = sorted[Math.min(sorted.length - 1, (int) (INLIER_FRACTION * sorted.length))];
        for (int i = 0; i < kept.length; i++) {
            kept[i] = distance[i] <= bound && distance[i] < Double.POSITIVE_INFINITY;
        }
    }

    /** The small motion after which the planes are nearest: sum of w (n . (p + r x (p - c) + t - q))^2 is least. */
    private RigidMotion gaussNewtonStep(double[] p, double[] nearest, double[] planes, boolean[] kept) {
        double[] c = new double[3];
        double total = 0;
        for (int i = 0; i < count; i++) {
            if (kept[i]) {
                total += weights[i];
                for (int k = 0; k < 3; k++) {
                    c[k] += weights[i] * p[3 * i + k];
                }
            }
        }
        for (int k = 0; k < 3; k++) {
            c[k] /= total;
        }
        DMatrixRMaj normal = new DMatrixRMaj(6, 6);
        DMatrixRMaj right = new DMatrixRMaj(6, 1);
        double[] row = new double[6];
        for (int i = 0; i < count; i++) {
            if (!kept[i]) {
                continue;
            }
            double off = 0;
            for (int k = 0; k < 3; k++) {
                int a = (k + 1) % 3;
                int b = (k + 2) % 3;
                row[k] = (p[3 * i + a] - c[a]) * planes[3 * i + b] - (p[3 * i + b] - c[b]) * planes[3 * i + a];
                row[3 + k] = planes[3 * i + k];
                off += planes[3 * i + k] * (nearest[3 * i + k] - p[3 * i + k]);
            }
            for (int a = 0; a < 6; a++) {
                for (int b = 0; b < 6; b++) {
                    normal.add(a, b, weights[i] * row[a] * row[b]);
                }
                right.add(a, 0, weights[i] * row[a] * off);
            }
        }
        for (int a = 0; a < 6; a++) {
            // A sphere says nothing of turns: they stay as they are.
            normal.add(a, a, (a < 3 ? ARM_MM * ARM_MM : 1) * DAMPING * total);
        }
        DMatrixRMaj solution = new DMatrixRMaj(6, 1);
        if (!CommonOps_DDRM.solve(normal, right, solution)) {
            return RigidMotion.identity();
        }
        double[] corners = new double[12];
        double[] moved = new double[12];
        for (int i = 0; i < 4; i++) {
            for (int k = 0; k < 3; k++) {
                corners[3 * i + k] = c[k] + (i == k + 1 ? ARM_MM : 0);
            }
            for (int k = 0; k < 3; k++) {
                int a = (k + 1) % 3;
                int b = (k + 2) % 3;
                moved[3 * i + k] = corners[3 * i + k]
                        + solution.get(a) * (corners[3 * i + b] - c[b])
                        - solution.get(b) * (corners[3 * i + a] - c[a])
                        + solution.get(3 + k);
            }
        }
        return RigidMotion.fit(corners, moved);
    }
}
