package org.phrenic.engine.integrator;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SelectiveMass;
import org.phrenic.engine.math.DenseVectors;
import org.phrenic.engine.parallel.Workers;

/**
 * The square of the highest angular frequency of a system: the largest eigenvalue of A = M^(-1/2) K M^(-1/2), by the
 * Lanczos method (1950, doi 10.6028/jres.045.026) from a fixed start vector that varies strongly between nodes.
 *
 * <pre>
 * β(j+1) q(j+1) = A q(j) - α(j) q(j) - β(j) q(j-1),   α(j) = q(j) · A q(j)
 * </pre>
 *
 * <p>The largest eigenvalue of the tridiagonal matrix of α and β is a lower bound that converges from below. After 20
 * products with K it is as accurate as power iteration after several times as many. The vectors are not
 * reorthogonalised, because that would only remove repeated copies of eigenvalues.
 */
final class HighestFrequency {
    private static final int PRODUCTS = 20;
    /** Relative norm below which a vector is rounding error: the Krylov space is exhausted. */
    private static final double EXHAUSTED = 1e-14;
    /** Number of bisections, enough for full double precision. */
    private static final int HALVINGS = 60;

    private final ParticleSystem system;
    private final double[] root;
    private double[] q;
    private double[] before;
    private final double[] u;
    private final double[] image;
    private final Workers.Task stiffness;
    private final Optional<SelectiveMass> stretch;
    private final double[] diagonal = new double[PRODUCTS];
    private final double[] offDiagonal = new double[PRODUCTS + 1];

    /** Of nodes {@code first} to {@code end - 1}, on which no others act. */
    private HighestFrequency(ParticleSystem system, int first, int end) {
        this.system = system;
        stretch = first == 0 ? system.selectiveMass() : Optional.empty();
        double[] w = system.inverseMasses();
        root = new double[w.length];
        q = new double[3 * w.length];
        before = new double[q.length];
        u = new double[q.length];
        image = new double[q.length];
        stiffness = block -> system.addStiffness(system.positions(), u, image, block);
        for (int n = first; n < end; n++) {
            root[n] = Math.sqrt(w[n]);
            for (int i = 3 * n; i < 3 * n + 3 && w[n] > 0; i++) {
                // Irregular alternating signs: close to the highest mode, and orthogonal to no mode.
                q[i] = ((((i * 2654435761L) >>> 7) & 1) == 0 ? 1 : -1) * (1 + i % 7 / 7.0) / root[n];
            }
        }
    }

    /**
     * ω² of nodes {@code first} to {@code end - 1} at the system's current state, 1/s², on which no other nodes act; 0
     * without free nodes, not finite if the state is not.
     */
    static double omegaSquared(ParticleSystem system, int first, int end) {
        return new HighestFrequency(system, first, end).find();
    }

    private double find() {
        double norm = Math.sqrt(DenseVectors.dot(q, q));
        if (norm == 0) {
            return 0;
        }
        scale(q, 1 / norm);
        int found = 0;
        boolean more = true;
        while (more && found < PRODUCTS) {
            multiply(offDiagonal[found]);
            diagonal[found] = DenseVectors.dot(q, image);
            DenseVectors.addScaled(image, -diagonal[found], q);
            offDiagonal[++found] = Math.sqrt(DenseVectors.dot(image, image));
            more = offDiagonal[found] > EXHAUSTED * diagonal[0];
            double[] old = before;
            before = q;
            q = old;
            System.arraycopy(image, 0, q, 0, q.length);
            scale(q, 1 / offDiagonal[found]);
        }
        return largest(found);
    }

    /** Writes A q minus {@code less} times the previous vector to {@code image}. */
    private void multiply(double less) {
        System.arraycopy(q, 0, u, 0, q.length);
        stretch.ifPresent(group -> group.stretch(u));
        byRoot(u, u);
        Arrays.fill(image, 0);
        system.workers().run(system.layout().blockCount(), stiffness);
        byRoot(image, image);
        stretch.ifPresent(group -> group.stretch(image));
        DenseVectors.addScaled(image, -less, before);
    }

    private void byRoot(double[] from, double[] to) {
        for (int n = 0; n < root.length; n++) {
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                to[i] = root[n] * from[i];
            }
        }
    }

    private static void scale(double[] v, double by) {
        for (int i = 0; i < v.length; i++) {
            v[i] *= by;
        }
    }

    /** Largest eigenvalue of the leading tridiagonal matrix, by bisection. */
    private double largest(int rows) {
        double low = 0;
        double high = 0;
        for (int j = 0; j < rows; j++) {
            high = Math.max(high, diagonal[j] + offDiagonal[j] + (j + 1 < rows ? offDiagonal[j + 1] : 0));
        }
        for (int k = 0; k < HALVINGS; k++) {
            double middle = 0.5 * (low + high);
            if (isAboveAll(middle, rows)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }

    /**
     * Whether a number is greater than all eigenvalues: all pivots of (number times the identity minus the matrix) are
     * positive.
     */
    private boolean isAboveAll(double number, int rows) {
        double pivot = number - diagonal[0];
        for (int j = 1; j < rows && pivot > 0; j++) {
            pivot = number - diagonal[j] - offDiagonal[j] * offDiagonal[j] / pivot;
        }
        return pivot > 0;
    }
}
