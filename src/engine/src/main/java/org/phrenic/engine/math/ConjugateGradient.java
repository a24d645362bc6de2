package org.phrenic.engine.math;

/**
 * Matrix-free preconditioned conjugate gradients for A x = b (Hestenes and Stiefel 1952, doi 10.6028/jres.049.044):
 *
 * <pre>
 * z = M⁻¹ r,  ρ = r · z,  q = A d,  α = ρ / d · q,  x += α d,  r -= α q,  d = z' + (ρ' / ρ) d
 * </pre>
 *
 * <p>A subclass provides A and M⁻¹. For least squares, min |b - A x|, use z = Aᵀ r, ρ = z · z and α = ρ / q · q (CGLS).
 * Sums have a fixed order; a solve allocates nothing.
 */
public abstract class ConjugateGradient {
    private final double[] z;
    private final double[] direction;
    private final double[] image;
    private double rho;
    private int iterations;
    private boolean exhausted;

    /**
     * @param unknowns length of x
     * @param equations length of b
     */
    protected ConjugateGradient(int unknowns, int equations) {
        z = new double[unknowns];
        direction = new double[unknowns];
        image = new double[equations];
    }

    /** Writes A d to {@code out}. */
    protected abstract void multiply(double[] d, double[] out);

    /** Writes z = M⁻¹ r to {@code out}. */
    protected abstract void precondition(double[] residual, double[] out);

    /** The inner product a · b. */
    protected double dot(double[] a, double[] b) {
        return DenseVectors.dot(a, b);
    }

    /** The value ρ. */
    protected double rho(double[] residual, double[] preconditioned) {
        return dot(residual, preconditioned);
    }

    /** The denominator of α. */
    protected double curvature(double[] d, double[] q) {
        return dot(d, q);
    }

    /** Measure compared with the goal: ρ by default. */
    protected double stopMeasure(double currentRho, double[] residual) {
        return currentRho;
    }

    /**
     * Initialises the search direction from the residual b - A x.
     *
     * @return ρ of this residual
     */
    public final double start(double[] residual) {
        precondition(residual, z);
        System.arraycopy(z, 0, direction, 0, z.length);
        rho = rho(residual, z);
        return rho;
    }

    /**
     * Iterates after {@link #start} until the stop measure is at most the goal.
     *
     * @param x initial guess, updated in place
     * @param residual b - A x, updated in place
     * @param goal bound of the stop measure
     * @param maxIterations maximum number of iterations
     * @return false if the iteration stopped at a direction along which A is not positive
     */
    public final boolean solve(double[] x, double[] residual, double goal, int maxIterations) {
        exhausted = false;
        for (iterations = 0; iterations < maxIterations && stopMeasure(rho, residual) > goal; iterations++) {
            multiply(direction, image);
            double curvature = curvature(direction, image);
            if (!(curvature > 0)) {
                return false;
            }
            double alpha = rho / curvature;
            DenseVectors.addScaled(x, alpha, direction);
            DenseVectors.addScaled(residual, -alpha, image);
            precondition(residual, z);
            double next = rho(residual, z);
            double beta = next / rho;
            for (int i = 0; i < direction.length; i++) {
                direction[i] = z[i] + beta * direction[i];
            }
            rho = next;
        }
        exhausted = stopMeasure(rho, residual) > goal;
        return true;
    }

    /** Whether the last solve ended at its maximum number of iterations, above the goal. */
    public final boolean isExhausted() {
        return exhausted;
    }

    /** Number of iterations of the last solve. */
    public final int iterations() {
        return iterations;
    }
}
