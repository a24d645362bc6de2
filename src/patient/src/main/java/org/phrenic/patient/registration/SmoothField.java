package org.phrenic.patient.registration;

import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
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
    private final double[] nodes;
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
        nodes = pairs.from();
        coefficients = new double[nodes.length];
        double[] sigma = pairs.sigma();
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
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                double value = kernel(3 * i, nodes, 3 * j, coupling);
                k.unsafe_set(i, j, value);
                k.unsafe_set(j, i, value);
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
        LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(n);
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

    private double kernel(int node, double[] p, int at, double coupling) {
        double dy = nodes[node + 1] - p[at + 1];
        double dz = nodes[node + 2] - p[at + 2];
        double rest = dy * dy + dz * dz;
        double dx = nodes[node] - p[at];
        double value = covariance(dx * dx + rest);
        if (coupling != 0) {
            double mx = nodes[node] - (2 * plane - p[at]);
            value += coupling * covariance(mx * mx + rest);
        }
        return value;
    }

    private double covariance(double squared) {
        double sum = 0;
        for (Scale scale : scales) {
            if (squared < scale.radiusMm * scale.radiusMm) {
                double r = Math.sqrt(squared) / scale.radiusMm;
                double q = (1 - r) * (1 - r);
                sum += scale.amplitudeMm * scale.amplitudeMm * q * q * (4 * r + 1);
            }
        }
        return sum;
    }

    /** Displacements at points, x, y, z in turn, mm. */
    double[] at(double[] points) {
        double[] out = new double[points.length];
        IntStream.range(0, points.length / 3).parallel().forEach(i -> add(points, 3 * i, out));
        return out;
    }

    private void add(double[] points, int at, double[] out) {
        for (int node = 0; node < nodes.length; node += 3) {
            double dy = nodes[node + 1] - points[at + 1];
            double dz = nodes[node + 2] - points[at + 2];
            double rest = dy * dy + dz * dz;
            double dx = nodes[node] - points[at];
            double direct = covariance(dx * dx + rest);
            double mx = nodes[node] - (2 * plane - points[at]);
            double image = mirror == 0 ? 0 : mirror * covariance(mx * mx + rest);
            out[at] += (direct - image) * coefficients[node];
            out[at + 1] += (direct + image) * coefficients[node + 1];
            out[at + 2] += (direct + image) * coefficients[node + 2];
        }
    }

    @Override
    public void apply(double[] points) {
        double[] moved = at(points);
        for (int i = 0; i < points.length; i++) {
            points[i] += moved[i];
        }
    }
}
