package org.phrenic.patient.registration;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Trimmed iterative closest points with point to plane distances (Chen and Medioni 1992, doi
 * 10.1016/0262-8856(92)90066-C; Chetverikov, Stepanov and Krsek 2005, doi 10.1016/j.imavis.2004.05.007). Points of the
 * first scan are moved toward the second. Each iteration selects the fraction {@value #INLIER_FRACTION} of the points
 * that is nearest to the surface. It then finds the small rotation r and translation t around their centroid c that
 * minimise {@code sum w (n . (p + r x (p - c) + t - q))^2}. Here q is the nearest surface point to p, and n is the
 * normal at q.
 */
final class TrimmedIcp {
    static final double INLIER_FRACTION = 0.7;
    private static final int ROUNDS = 80;
    /** Minimum cosine of the angle between the normals of a point and of its nearest surface point. */
    private static final double MIN_NORMAL_COSINE = 0.5;
    /** Length scale that weighs rotations against translations, mm. It is about the size of the body. */
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

    /**
     * Nearest points of one iteration with normals and distances. A distance is infinite if the normals differ too
     * much.
     */
    private record Nearest(double[] points, double[] normals, double[] distances) {}

    /** @param fixed marks the vertices of the first scan to use */
    TrimmedIcp(TriangleMesh first, boolean[] fixed, TriangleMesh second) {
        surface = second;
        tree = new TriangleTree(second);
        surfaceNormals = MeshMeasure.triangleNormals(second);
        int[] used = IntStream.range(0, fixed.length).filter(v -> fixed[v]).toArray();
        count = used.length;
        points = Vectors.gather(first.positions(), used);
        normals = Vectors.gather(MeshMeasure.vertexNormals(first), used);
        double[] areas = MeshMeasure.vertexAreas(first);
        weights = Arrays.stream(used).mapToDouble(v -> areas[v]).toArray();
        double[] a = first.bounds();
        double[] b = second.bounds();
        // Lungs differ in depth and at the base. The start matches their tops, backs and lateral centres.
        start = new double[] {(b[0] + b[3] - a[0] - a[3]) / 2, b[4] - a[4], b[5] - a[5]};
    }

    /** @param centred whether to start with matched centroids instead of matched tops and backs */
    ScanAlignment align(ScanAlignment.FixedPart part, boolean centred) {
        RigidMotion motion = centred ? centroidTranslation() : RigidMotion.translation(start[0], start[1], start[2]);
        double[] p = points.clone();
        boolean[] inliers = new boolean[count];
        for (int round = 0; round <= ROUNDS; round++) {
            System.arraycopy(points, 0, p, 0, p.length);
            motion.apply(p);
            Nearest nearest = findCorrespondences(p, motion);
            inliers = trimmed(nearest.distances);
            if (round < ROUNDS) {
                motion = gaussNewtonStep(p, nearest, inliers).after(motion);
            }
        }
        double[] distances = new double[count];
        double[] inlierWeights = new double[count];
        for (int i = 0; i < count; i++) {
            tree.closest(p[3 * i], p[3 * i + 1], p[3 * i + 2], hit);
            distances[i] = Math.sqrt(hit.distanceSquared);
            inlierWeights[i] = inliers[i] ? weights[i] : 0;
        }
        return new ScanAlignment(
                motion.inverse(),
                part,
                DistanceSummary.of(distances, weights),
                DistanceSummary.of(distances, inlierWeights));
    }

    private RigidMotion centroidTranslation() {
        double[] shift = new double[3];
        for (int i = 0; i < points.length; i++) {
            shift[i % 3] -= points[i] / count;
        }
        for (int i = 0; i < surface.positions().length; i++) {
            shift[i % 3] += surface.positions()[i] / surface.vertexCount();
        }
        return RigidMotion.translation(shift[0], shift[1], shift[2]);
    }

    private Nearest findCorrespondences(double[] p, RigidMotion motion) {
        Nearest nearest = new Nearest(new double[3 * count], new double[3 * count], new double[count]);
        for (int i = 0; i < count; i++) {
            tree.closest(p[3 * i], p[3 * i + 1], p[3 * i + 2], hit);
            nearest.points[3 * i] = hit.x;
            nearest.points[3 * i + 1] = hit.y;
            nearest.points[3 * i + 2] = hit.z;
            double cosine = 0;
            for (int k = 0; k < 3; k++) {
                double normal = motion.rotation(k, 0) * normals[3 * i]
                        + motion.rotation(k, 1) * normals[3 * i + 1]
                        + motion.rotation(k, 2) * normals[3 * i + 2];
                nearest.normals[3 * i + k] = surfaceNormals[3 * hit.triangle + k];
                cosine += nearest.normals[3 * i + k] * normal;
            }
            nearest.distances[i] =
                    cosine > MIN_NORMAL_COSINE ? Math.sqrt(hit.distanceSquared) : Double.POSITIVE_INFINITY;
        }
        return nearest;
    }

    private static boolean[] trimmed(double[] distances) {
        double[] sorted = distances.clone();
        Arrays.sort(sorted);
        double bound = sorted[Math.min(sorted.length - 1, (int) (INLIER_FRACTION * sorted.length))];
        boolean[] inliers = new boolean[distances.length];
        for (int i = 0; i < inliers.length; i++) {
            inliers[i] = distances[i] <= bound && distances[i] < Double.POSITIVE_INFINITY;
        }
        return inliers;
    }

    /** Small motion that minimises the point to plane distances. */
    private RigidMotion gaussNewtonStep(double[] p, Nearest nearest, boolean[] inliers) {
        double[] c = new double[3];
        double total = 0;
        for (int i = 0; i < count; i++) {
            if (inliers[i]) {
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
        for (int i = 0; i < count; i++) {
            if (inliers[i]) {
                addEquation(3 * i, p, nearest, c, normal, right);
            }
        }
        for (int a = 0; a < 6; a++) {
            // Damps rotations that the points do not determine, such as those of a sphere.
            normal.add(a, a, (a < 3 ? ARM_MM * ARM_MM : 1) * DAMPING * total);
        }
        DMatrixRMaj solution = new DMatrixRMaj(6, 1);
        return CommonOps_DDRM.solve(normal, right, solution) ? motion(solution, c) : RigidMotion.identity();
    }

    private void addEquation(int at, double[] p, Nearest nearest, double[] c, DMatrixRMaj normal, DMatrixRMaj right) {
        double weight = weights[at / 3];
        double[] n = nearest.normals;
        double[] row = new double[6];
        double off = 0;
        for (int k = 0; k < 3; k++) {
            int a = (k + 1) % 3;
            int b = (k + 2) % 3;
            row[k] = (p[at + a] - c[a]) * n[at + b] - (p[at + b] - c[b]) * n[at + a];
            row[3 + k] = n[at + k];
            off += n[at + k] * (nearest.points[at + k] - p[at + k]);
        }
        for (int a = 0; a < 6; a++) {
            for (int b = 0; b < 6; b++) {
                normal.add(a, b, weight * row[a] * row[b]);
            }
            right.add(a, 0, weight * row[a] * off);
        }
    }

    /** Rigid motion closest to a small rotation and translation around c, fitted to four points. */
    private static RigidMotion motion(DMatrixRMaj solution, double[] c) {
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
