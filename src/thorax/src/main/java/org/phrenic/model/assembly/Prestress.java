package org.phrenic.model.assembly;

import java.util.Arrays;
import org.phrenic.engine.math.ConjugateGradient;
import org.phrenic.engine.math.DenseVectors;

/**
 * Spring tensions that hold a given shape in equilibrium under a given load. Starting from a first guess t0, it finds
 * the closest least-squares solution of Σ_e t_e d_e + load = 0 at every node, by conjugate gradients on the normal
 * equations. Rest lengths follow as l - t / k, so the scanned shape is the equilibrium at rest.
 */
public final class Prestress {
    private final int[] nodeA;
    private final int[] nodeB;
    private final double[] direction;
    private final int nodes;
    private final boolean[] free;
    private final double[] wallNormal;

    /**
     * @param positions at rest, three numbers per node, mm
     * @param nodeA first end of each spring
     * @param nodeB second end of each spring
     * @param free whether forces at a node must balance; false where it is attached to bone
     * @param wallNormal unit normal of the wall at a node in contact with it, zero elsewhere: at a node in contact only
     *     the tangential forces must balance
     */
    Prestress(double[] positions, int[] nodeA, int[] nodeB, boolean[] free, double[] wallNormal) {
        this.nodeA = nodeA;
        this.nodeB = nodeB;
        this.nodes = positions.length / 3;
        this.free = free;
        this.wallNormal = wallNormal;
        direction = new double[3 * nodeA.length];
        for (int e = 0; e < nodeA.length; e++) {
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = positions[3 * nodeB[e] + axis] - positions[3 * nodeA[e] + axis];
                direction[3 * e + axis] = d;
                squared += d * d;
            }
            double inverse = 1 / Math.sqrt(squared);
            for (int axis = 0; axis < 3; axis++) {
                direction[3 * e + axis] *= inverse;
            }
        }
    }

    /**
     * Solves for the tensions.
     *
     * @param load force on each node, mN
     * @param tension first guess on input, result on output, mN
     * @param iterations of conjugate gradients
     * @return relative residual: unbalanced force over load (root mean square); 0 without load
     */
    double solve(double[] load, double[] tension, int iterations) {
        double[] residual = load.clone();
        projectOutConstraints(residual);
        double norm = Math.sqrt(DenseVectors.dot(residual, residual));
        residual = unbalancedForce(load, tension);
        for (int i = 0; i < residual.length; i++) {
            residual[i] = -residual[i];
        }
        TensionSolver solver = new TensionSolver();
        solver.start(residual);
        solver.solve(tension, residual, 0, iterations);
        return norm > 0 ? Math.sqrt(DenseVectors.dot(residual, residual)) / norm : 0;
    }

    /** Least-squares problem: the projected matrix of edge directions and its transpose. */
    private final class TensionSolver extends ConjugateGradient {
        TensionSolver() {
            super(nodeA.length, 3 * nodes);
        }

        @Override
        protected void multiply(double[] tension, double[] force) {
            Arrays.fill(force, 0);
            addForces(tension, force);
            projectOutConstraints(force);
        }

        @Override
        protected void precondition(double[] force, double[] gradient) {
            transpose(force, gradient);
        }

        @Override
        protected double rho(double[] force, double[] gradient) {
            return dot(gradient, gradient);
        }

        @Override
        protected double curvature(double[] tension, double[] force) {
            return dot(force, force);
        }
    }

    /** Unbalanced force at each node, mN; zero at attached nodes and in the direction of the wall normal. */
    double[] unbalancedForce(double[] load, double[] tension) {
        double[] out = load.clone();
        addForces(tension, out);
        projectOutConstraints(out);
        return out;
    }

    private void addForces(double[] tension, double[] force) {
        for (int e = 0; e < tension.length; e++) {
            addTension(tension[e], 3 * e, 3 * nodeA[e], 3 * nodeB[e], force);
        }
    }

    private void addTension(double tension, int at, int a, int b, double[] force) {
        for (int axis = 0; axis < 3; axis++) {
            double f = tension * direction[at + axis];
            force[a + axis] += f;
            force[b + axis] -= f;
        }
    }

    private void transpose(double[] force, double[] out) {
        for (int e = 0; e < out.length; e++) {
            out[e] = dotDirection(3 * e, 3 * nodeA[e], 3 * nodeB[e], force);
        }
    }

    private double dotDirection(int at, int a, int b, double[] force) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum += direction[at + axis] * (force[a + axis] - force[b + axis]);
        }
        return sum;
    }

    private void projectOutConstraints(double[] force) {
        for (int n = 0; n < nodes; n++) {
            int i = 3 * n;
            if (!free[n]) {
                force[i] = 0;
                force[i + 1] = 0;
                force[i + 2] = 0;
                continue;
            }
            double across =
                    force[i] * wallNormal[i] + force[i + 1] * wallNormal[i + 1] + force[i + 2] * wallNormal[i + 2];
            for (int axis = 0; axis < 3; axis++) {
                force[i + axis] -= across * wallNormal[i + axis];
            }
        }
    }
}
