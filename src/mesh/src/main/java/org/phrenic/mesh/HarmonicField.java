package org.phrenic.mesh;

import java.util.Arrays;
import org.phrenic.engine.math.ConjugateGradient;

/**
 * A harmonic scalar field: the solution u of Laplace's equation on a surface with prescribed values at given vertices.
 * With linear elements, each free vertex i satisfies: sum over its edges (i, j) of w_ij (u_i - u_j) = 0. The weights
 * are w_ij = (cot alpha + cot beta) / 2 with the angles opposite the edge (Pinkall and Polthier 1993, doi
 * 10.1080/10586458.1993.10504266). The gradient points from low to high prescribed values and has no sources in
 * between, so it serves as a fibre direction.
 *
 * <p>Free boundaries have the natural (Neumann) condition: the gradient is tangent to the boundary. The system is
 * solved by conjugate gradients with Jacobi preconditioning, in a fixed order of summation.
 */
public final class HarmonicField {
    private static final double RELATIVE_RESIDUAL = 1e-10;
    /**
     * Least weight, which keeps the matrix positive definite with obtuse or degenerate triangles; an equilateral pair
     * has 0.58.
     */
    private static final double MIN_WEIGHT = 1e-3;

    private static final double MAX_WEIGHT = 1e3;

    private final TriangleMesh mesh;
    private final double[] values;

    private HarmonicField(TriangleMesh mesh, double[] values) {
        this.mesh = mesh;
        this.values = values;
    }

    /**
     * Solves for the values at all free vertices.
     *
     * @param fixed vertices with prescribed values, at least one; for a repeated vertex the last value is used
     * @param given prescribed values, in the same order
     * @throws IllegalArgumentException if the two differ in length, are empty, or contain a vertex outside the mesh
     */
    public static HarmonicField solve(TriangleMesh mesh, MeshTopology topology, int[] fixed, double[] given) {
        if (fixed.length != given.length || fixed.length == 0) {
            throw new IllegalArgumentException("harmonic field: " + fixed.length + " fixed vertices and " + given.length
                    + " values, expected as many of each and at least one");
        }
        int count = mesh.vertexCount();
        boolean[] isFixed = new boolean[count];
        double[] u = new double[count];
        double mean = 0;
        for (double value : given) {
            mean += value / given.length;
        }
        // A component without a fixed vertex keeps the mean of the prescribed values.
        Arrays.fill(u, mean);
        for (int k = 0; k < fixed.length; k++) {
            if (fixed[k] < 0 || fixed[k] >= count) {
                throw new IllegalArgumentException(
                        "harmonic field: fixed vertex " + fixed[k] + ", expected 0 to " + (count - 1));
            }
            isFixed[fixed[k]] = true;
            u[fixed[k]] = given[k];
        }
        double[] weights = limitedWeights(mesh, topology);
        solve(topology, weights, isFixed, u);
        return new HarmonicField(mesh, u);
    }

    /** Value at each vertex; shared, must not be modified. */
    public double[] values() {
        return values;
    }

    /** Gradient in each triangle, x y z in turn, in units of the value per mm; zero in a degenerate triangle. */
    public double[] gradients() {
        double[] gradients = new double[mesh.triangles().length];
        double[] n = new double[3];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            addGradient(i, n, gradients);
        }
        return gradients;
    }

    private void addGradient(int triangle, double[] n, double[] gradients) {
        double twiceArea = MeshMeasure.triangleCrossProduct(mesh, triangle, n);
        if (twiceArea == 0) {
            return;
        }
        double[] p = mesh.positions();
        int[] t = mesh.triangles();
        int at = 3 * triangle;
        for (int corner = 0; corner < 3; corner++) {
            // grad u = sum of u_c (n x e_c) / (2 A), with e_c the side opposite corner c and n the unit normal.
            int b = 3 * t[at + (corner + 1) % 3];
            int c = 3 * t[at + (corner + 2) % 3];
            double scale = values[t[at + corner]] / (twiceArea * twiceArea);
            double ex = p[c] - p[b];
            double ey = p[c + 1] - p[b + 1];
            double ez = p[c + 2] - p[b + 2];
            gradients[at] += scale * (n[1] * ez - n[2] * ey);
            gradients[at + 1] += scale * (n[2] * ex - n[0] * ez);
            gradients[at + 2] += scale * (n[0] * ey - n[1] * ex);
        }
    }

    private static double[] limitedWeights(TriangleMesh mesh, MeshTopology topology) {
        double[] weights = CotangentWeights.of(mesh, topology);
        for (int e = 0; e < weights.length; e++) {
            weights[e] = Math.max(MIN_WEIGHT, Math.min(MAX_WEIGHT, weights[e]));
        }
        return weights;
    }

    /** Solves for the free entries of u in place; the given u is the initial guess. */
    private static void solve(MeshTopology topology, double[] weights, boolean[] isFixed, double[] u) {
        int count = u.length;
        double[] diagonal = new double[count];
        int[] edges = topology.edges();
        for (int e = 0; e < weights.length; e++) {
            diagonal[edges[2 * e]] += weights[e];
            diagonal[edges[2 * e + 1]] += weights[e];
        }
        ConjugateGradient solver = new ConjugateGradient(count, count) {
            @Override
            protected void multiply(double[] x, double[] out) {
                HarmonicField.multiply(edges, weights, isFixed, x, out);
            }

            @Override
            protected void precondition(double[] residual, double[] out) {
                for (int v = 0; v < out.length; v++) {
                    out[v] = diagonal[v] > 0 ? residual[v] / diagonal[v] : 0;
                }
            }
        };
        double[] residual = new double[count];
        multiply(edges, weights, isFixed, u, residual);
        for (int v = 0; v < count; v++) {
            residual[v] = -residual[v];
        }
        double goal = solver.start(residual) * RELATIVE_RESIDUAL * RELATIVE_RESIDUAL;
        solver.solve(u, residual, goal, 10 * count + 100);
    }

    /** Writes L x into {@code out} for the free vertices, 0 for the fixed ones. */
    private static void multiply(int[] edges, double[] weights, boolean[] isFixed, double[] x, double[] out) {
        Arrays.fill(out, 0);
        for (int e = 0; e < weights.length; e++) {
            int a = edges[2 * e];
            int b = edges[2 * e + 1];
            double flow = weights[e] * (x[a] - x[b]);
            out[a] += flow;
            out[b] -= flow;
        }
        for (int v = 0; v < out.length; v++) {
            if (isFixed[v]) {
                out[v] = 0;
            }
        }
    }
}
