package org.phrenic.model.material;

import org.phrenic.model.organ.SpringList;

/**
 * Mass scaling: increases the mass of the few nodes that are so light for the stiffness of their springs that they
 * alone would limit the time step, until a given step is stable. Breathing is quasi-static, so a small added mass at a
 * few nodes does not change the observed motion. Explicit finite element codes do the same for slow processes. Physical
 * preset only; the paper has no mass scaling.
 *
 * <p>With springs k along unit vectors n and A_i = Σ k n nᵀ over the springs at node i, the energy Σ k (n·(u_a - u_b))²
 * is at most 2 Σ u_iᵀ A_i u_i. No frequency therefore exceeds the largest of ω_i² = 2 λ_max(A_i) / m_i; on a triangular
 * lattice the bound is attained. Tissue that folds turns its springs; then the trace of A_i bounds the eigenvalue in
 * any shape ({@link #leastMassForAnyShape}). A spring to bone counts half. Every mass is raised to at least 2
 * λ_max(A_i) / ω².
 */
final class MassScaling {
    /** Number of entries of the upper triangle of A_i: xx, xy, xz, yy, yz, zz. */
    private static final int SYMMETRIC = 6;

    private final double[] positions;
    private final double[] nodeStiffness;
    /** The part of A_i that is the same in all directions, N/m. */
    private final double[] isotropic;

    /** @param positions of all nodes, mm */
    MassScaling(double[] positions) {
        this.positions = positions;
        nodeStiffness = new double[SYMMETRIC * (positions.length / 3)];
        isotropic = new double[positions.length / 3];
    }

    /** Adds springs between nodes to A_i. */
    void addSprings(SpringList springs) {
        int[] a = springs.nodeA();
        int[] b = springs.nodeB();
        double[] k = springs.stiffness();
        for (int e = 0; e < a.length; e++) {
            addSpring(a[e], b[e], k[e]);
        }
    }

    private void addSpring(int a, int b, double k) {
        double x = positions[3 * b] - positions[3 * a];
        double y = positions[3 * b + 1] - positions[3 * a + 1];
        double z = positions[3 * b + 2] - positions[3 * a + 2];
        double s = k / (x * x + y * y + z * z);
        addOuterProduct(a, s, x, y, z);
        addOuterProduct(b, s, x, y, z);
    }

    private void addOuterProduct(int node, double s, double x, double y, double z) {
        int at = SYMMETRIC * node;
        nodeStiffness[at] += s * x * x;
        nodeStiffness[at + 1] += s * x * y;
        nodeStiffness[at + 2] += s * x * z;
        nodeStiffness[at + 3] += s * y * y;
        nodeStiffness[at + 4] += s * y * z;
        nodeStiffness[at + 5] += s * z * z;
    }

    /** Adds springs to bone to A_i, or other row sums of a stiffness matrix. They are isotropic. */
    void addAttachments(int[] nodes, double[] k, double factor) {
        for (int i = 0; i < nodes.length; i++) {
            double half = 0.5 * factor * k[i];
            int at = SYMMETRIC * nodes[i];
            nodeStiffness[at] += half;
            nodeStiffness[at + 3] += half;
            nodeStiffness[at + 5] += half;
            isotropic[nodes[i]] += half;
        }
    }

    /** Mass of each node from which velocity Verlet is stable with this step (s), kg. */
    double[] leastMasses(double step) {
        double omega = 2 / step;
        double[] least = new double[positions.length / 3];
        for (int i = 0; i < least.length; i++) {
            least[i] = 2 * largestEigenvalue(SYMMETRIC * i) / (omega * omega);
        }
        return least;
    }

    /**
     * Mass of a node from which velocity Verlet is stable with this step (s) whichever way its springs turn, kg: the
     * trace of A_i, which is that of all springs along one line, in place of the largest eigenvalue.
     */
    double leastMassForAnyShape(int node, double step) {
        int at = SYMMETRIC * node;
        double trace = nodeStiffness[at] + nodeStiffness[at + 3] + nodeStiffness[at + 5] - 2 * isotropic[node];
        double omega = 2 / step;
        return 2 * trace / (omega * omega);
    }

    /** Largest eigenvalue of a symmetric 3 × 3 matrix in closed form (Smith 1961, doi 10.1145/355578.366316). */
    private double largestEigenvalue(int at) {
        double xy = nodeStiffness[at + 1];
        double xz = nodeStiffness[at + 2];
        double yz = nodeStiffness[at + 4];
        double mean = (nodeStiffness[at] + nodeStiffness[at + 3] + nodeStiffness[at + 5]) / 3;
        double xx = nodeStiffness[at] - mean;
        double yy = nodeStiffness[at + 3] - mean;
        double zz = nodeStiffness[at + 5] - mean;
        double p = Math.sqrt((xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz)) / 6);
        if (p == 0) {
            return mean;
        }
        double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
        double r = Math.max(-1, Math.min(1, determinant / (2 * p * p * p)));
        return mean + 2 * p * StrictMath.cos(StrictMath.acos(r) / 3);
    }
}
