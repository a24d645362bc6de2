package org.phrenic.patient.registration;

import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.linsol.chol.LinearSolverChol_DDRB;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * A smooth displacement field through point pairs: the mean of a Gaussian process (Luethi, Gerig, Jud and Vetter 2018,
 * doi 10.1109/TPAMI.2017.2739743) that observes {@code to - from} with the pairs' standard deviations.
 *
 * <pre>
 * u(x) = sum_i k(x, p_i) a_i,   (K + diag(sigma^2)) a = to - from
 * k(x, y) = sum_s A_s^2 psi(|x - y| / R_s),   psi(r) = (1 - r)^4 (4 r + 1) for r &lt; 1 (Wendland 1995)
 * </pre>
 *
 * The field decays to zero where no pair is near. With a mirror coupling c the displacements at x and at its mirror
 * image Mx about the plane {@code x = plane} have the correlation c: {@code k(x, y) I + c k(x, My) M}. What is known of
 * one side of the body then shapes the other, as far as nothing is known of that.
 */
final class SmoothField implements PointTransform {
    private static final int POINTS_A_PIECE = 64;

    private final double[] nodeX;
    private final double[] nodeY;
    private final double[] nodeZ;
    private final double[] coefficients;
    private final Scale[] scales;
    private final double mirror;
    private final double plane;

    /**
     * One scale of the kernel.
     *
     * @param radiusMm distance beyond which displacements are independent
     * @param amplitudeMm standard deviation of the displacements
     */
    record Scale(double radiusMm, double amplitudeMm) {}

    /**
     * Fits the field.
     *
     * @param displacements of the pairs' template points, x, y, z in turn, mm
     * @param mirror coupling of both sides, 0 to below 1
     * @param plane x of the plane of symmetry, mm
     */
    SmoothField(PointPairs pairs, double[] displacements, Scale[] scales, double mirror, double plane) {
        this.scales = scales.clone();
        this.mirror = mirror;
        this.plane = plane;
        double[] nodes = pairs.from();
        coefficients = new double[nodes.length];
        double[] sigma = pairs.sigma();
        nodeX = new double[sigma.length];
        nodeY = new double[sigma.length];
        nodeZ = new double[sigma.length];
        for (int k = 0; k < sigma.length; k++) {
            nodeX[k] = nodes[3 * k];
            nodeY[k] = nodes[3 * k + 1];
            nodeZ[k] = nodes[3 * k + 2];
        }
        if (sigma.length == 0) {
            return;
        }
        // The mirror image of x changes its sign, those of y and z keep it.
        IntStream.range(0, mirror == 0 ? 1 : 2).parallel().forEach(part -> {
            int first = mirror == 0 || part == 0 ? 0 : 1;
            int last = mirror == 0 || part == 1 ? 2 : 0;
            solve(sigma, displacements, first, last, part == 0 ? -mirror : mirror);
        });
    }

    private void solve(double[] sigma, double[] displacements, int first, int last, double coupling) {
        int n = sigma.length;
        DMatrixRMaj k = new DMatrixRMaj(n, n);
        Evaluation evaluation = new Evaluation();
        for (int i = 0; i < n; i++) {
            evaluation.row(i, coupling);
            for (int j = 0; j <= i; j++) {
                k.unsafe_set(i, j, evaluation.direct[j]);
                k.unsafe_set(j, i, evaluation.direct[j]);
            }
            k.add(i, i, sigma[i] * sigma[i]);
        }
        int columns = last - first + 1;
        DMatrixRMaj right = new DMatrixRMaj(n, columns);
        for (int i = 0; i < n; i++) {
            for (int c = 0; c < columns; c++) {
                right.unsafe_set(i, c, displacements[3 * i + first + c]);
            }
        }
        LinearSolverDense<DMatrixRMaj> solver = new LinearSolverChol_DDRB();
        if (!solver.setA(k)) {
            throw new IllegalStateException("correspondences of " + n + " points: no smooth field through them");
        }
        DMatrixRMaj found = new DMatrixRMaj(n, columns);
        solver.solve(right, found);
        for (int i = 0; i < n; i++) {
            for (int c = 0; c < columns; c++) {
                coefficients[3 * i + first + c] = found.unsafe_get(i, c);
            }
        }
    }

    /**
     * Sums the scales of the kernel over distances.
     *
     * @param squared squared distances, mm^2; replaced by the distances
     * @param count number of distances
     * @param sum k at each distance, mm^2
     */
    private void covariances(double[] squared, int count, double[] sum) {
        for (int k = 0; k < count; k++) {
            squared[k] = Math.sqrt(squared[k]);
            sum[k] = 0;
        }
        // Loops without branches over arrays in sequence, which the compiler vectorises.
        for (Scale scale : scales) {
            double radius = scale.radiusMm;
            double variance = scale.amplitudeMm * scale.amplitudeMm;
            for (int k = 0; k < count; k++) {
                double r = squared[k] / radius;
                double q = Math.max(0, 1 - r) * Math.max(0, 1 - r);
                sum[k] += variance * q * q * (4 * r + 1);
            }
        }
    }

    /** Displacements at points, x, y, z in turn, mm. */
    double[] at(double[] points) {
        double[] out = new double[points.length];
        int count = points.length / 3;
        IntStream.range(0, (count + POINTS_A_PIECE - 1) / POINTS_A_PIECE)
                .parallel()
                .forEach(piece -> new Evaluation()
                        .add(points, piece * POINTS_A_PIECE, Math.min(count, (piece + 1) * POINTS_A_PIECE), out));
        return out;
    }

    /** Working memory of an evaluation on one thread. */
    private final class Evaluation {
        final double[] squared = new double[nodeX.length];
        final double[] direct = new double[nodeX.length];
        final double[] image = new double[nodeX.length];

        /** Displacements at points {@code from} to {@code end - 1}. */
        void add(double[] points, int from, int end, double[] out) {
            for (int at = 3 * from; at < 3 * end; at += 3) {
                squaredDistances(points[at], points[at + 1], points[at + 2]);
                covariances(squared, squared.length, direct);
                if (mirror != 0) {
                    squaredDistances(2 * plane - points[at], points[at + 1], points[at + 2]);
                    covariances(squared, squared.length, image);
                }
                double ux = 0;
                double uy = 0;
                double uz = 0;
                for (int k = 0; k < direct.length; k++) {
                    double mirrored = mirror * image[k];
                    ux += (direct[k] - mirrored) * coefficients[3 * k];
                    uy += (direct[k] + mirrored) * coefficients[3 * k + 1];
                    uz += (direct[k] + mirrored) * coefficients[3 * k + 2];
                }
                out[at] = ux;
                out[at + 1] = uy;
                out[at + 2] = uz;
            }
        }

        /** Squared distances of a point from all nodes. */
        private void squaredDistances(double x, double y, double z) {
            for (int k = 0; k < squared.length; k++) {
                double dx = nodeX[k] - x;
                double dy = nodeY[k] - y;
                double dz = nodeZ[k] - z;
                squared[k] = dx * dx + (dy * dy + dz * dz);
            }
        }

        /** Row i of the kernel matrix of the nodes, up to its diagonal, into {@code direct}. */
        void row(int i, double coupling) {
            for (int j = 0; j <= i; j++) {
                squared[j] = square(nodeX[i] - nodeX[j]) + besideX(i, j);
            }
            covariances(squared, i + 1, direct);
            if (coupling == 0) {
                return;
            }
            for (int j = 0; j <= i; j++) {
                squared[j] = square(nodeX[i] - (2 * plane - nodeX[j])) + besideX(i, j);
            }
            covariances(squared, i + 1, image);
            for (int j = 0; j <= i; j++) {
                direct[j] += coupling * image[j];
            }
        }

        private double besideX(int i, int j) {
            return square(nodeY[i] - nodeY[j]) + square(nodeZ[i] - nodeZ[j]);
        }
    }

    private static double square(double a) {
        return a * a;
    }

    @Override
    public void apply(double[] points) {
        double[] moved = at(points);
        for (int i = 0; i < points.length; i++) {
            points[i] += moved[i];
        }
    }
}
