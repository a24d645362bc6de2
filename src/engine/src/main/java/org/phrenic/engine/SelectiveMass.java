package org.phrenic.engine;

import java.util.Arrays;

/**
 * Selective mass scaling of a group of nodes: node masses that are large for the sake of the time step oppose the
 * deformation of the group, but not its translation. With node masses m, the group's mass M = Σ m and its mean velocity
 * ū = Σ m u / M, the inertia of the group is
 *
 * <pre>
 * (M_s u)_i = m_i (u_i - (1 - 1/s) ū)          (M_s⁻¹ f)_i = f_i / m_i + (s - 1) / M Σ f
 * </pre>
 *
 * <p>so that the group is translated as if it had the mass M / s. Frequencies of its deformation, which limit the time
 * step, are unchanged. For stiff tissue within soft tissue (Olovsson, Simonsson and Unosson 2005, doi
 * 10.1002/nme.1293). Forces that act between nodes of the group cancel in the sum; constraints on nodes of the group
 * must do so as well, because they use the node masses alone.
 */
public final class SelectiveMass {
    private final int[] nodes;
    private final double lightness;
    private final double[] masses;
    private double total = Double.NaN;
    private final double[] mean = new double[3];
    /** Work space of {@link #addedOmegaSquared}; null before its first use. */
    private double[] translation;

    private double[] stiffness;

    /**
     * @param nodes internal numbers of the group's free nodes
     * @param lightness the factor s by which the translation is lighter, at least 1
     * @param masses of all nodes in internal order, kg; read when {@link #invalidate} was called
     */
    SelectiveMass(int[] nodes, double lightness, double[] masses) {
        if (!(lightness >= 1) || Double.isInfinite(lightness)) {
            throw new IllegalArgumentException("selective mass: found factor " + lightness + ", expected 1 or more");
        }
        this.nodes = Arrays.stream(nodes).sorted().distinct().toArray();
        if (nodes.length == 0 || this.nodes.length < nodes.length) {
            throw new IllegalArgumentException("selective mass: found " + nodes.length + " nodes, of which "
                    + this.nodes.length + " differ, expected at least one and each once");
        }
        this.lightness = lightness;
        this.masses = masses;
    }

    /** Makes the next use read the masses anew. */
    void invalidate() {
        total = Double.NaN;
    }

    private double total() {
        if (Double.isNaN(total)) {
            double sum = 0;
            for (int n : nodes) {
                sum += masses[n];
            }
            total = sum;
        }
        return total;
    }

    /** Replaces f by M M_s⁻¹ f, so that force over node mass is the acceleration; three numbers a node. */
    void scaleForces(double[] force) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int n : nodes) {
            x += force[3 * n];
            y += force[3 * n + 1];
            z += force[3 * n + 2];
        }
        double factor = (lightness - 1) / total();
        add(force, factor * x, factor * y, factor * z);
    }

    /**
     * Adds factor (M_s - M) u, three numbers a node.
     *
     * @param u velocities or accelerations
     */
    public void addInertia(double factor, double[] u, double[] out) {
        mean(u, mean);
        double share = -factor * relief();
        add(out, share * mean[0], share * mean[1], share * mean[2]);
    }

    /** Viscosity over mass in the group, 1/s; it must be one number for all its nodes. */
    public double dampingRate(double[] viscosity) {
        return viscosity[nodes[0]] / masses[nodes[0]];
    }

    /** Internal numbers of the group's nodes, ascending. */
    public int[] nodes() {
        return nodes.clone();
    }

    /** The share 1 - 1/s of the group's mean velocity that has no inertia. */
    public double relief() {
        return 1 - 1 / lightness;
    }

    /** Puts the mean of velocities over the group, weighted by mass, into the first three numbers of {@code out}. */
    public void mean(double[] u, double[] out) {
        Arrays.fill(out, 0, 3, 0);
        for (int n : nodes) {
            for (int axis = 0; axis < 3; axis++) {
                out[axis] += masses[n] * u[3 * n + axis];
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            out[axis] /= total();
        }
    }

    private void add(double[] out, double x, double y, double z) {
        for (int n : nodes) {
            double m = masses[n];
            out[3 * n] += m * x;
            out[3 * n + 1] += m * y;
            out[3 * n + 2] += m * z;
        }
    }

    /**
     * Multiplies by I + (√s - 1) q qᵀ along each axis, q_i = √(m_i / M) in the group: with the root of the diagonal
     * masses on both sides, the root of M_s⁻¹.
     */
    public void stretch(double[] u) {
        for (int axis = 0; axis < 3; axis++) {
            double along = 0;
            for (int n : nodes) {
                along += Math.sqrt(masses[n]) * u[3 * n + axis];
            }
            double share = (Math.sqrt(lightness) - 1) * along / total();
            for (int n : nodes) {
                u[3 * n + axis] += Math.sqrt(masses[n]) * share;
            }
        }
    }

    /** What the group's lighter translation takes from the kinetic energy Σ m v² / 2, µJ. */
    double energyRelief(double[] v) {
        mean(v, mean);
        double squared = mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2];
        return 0.5 * relief() * total() * squared;
    }

    /**
     * Bound of what the lighter translation adds to the square of a system's highest frequency, 1/s²: (s - 1) / M times
     * the trace of the stiffness against translation of the group. Eigenvalues of a sum of two positive semidefinite
     * products with one stiffness do not exceed the sum of their largest.
     */
    public double addedOmegaSquared(ParticleSystem system) {
        if (translation == null) {
            translation = new double[3 * masses.length];
            stiffness = new double[3 * masses.length];
        }
        double[] u = translation;
        double[] out = stiffness;
        double trace = 0;
        for (int axis = 0; axis < 3; axis++) {
            Arrays.fill(u, 0);
            Arrays.fill(out, 0);
            for (int n : nodes) {
                u[3 * n + axis] = 1;
            }
            for (int block = 0; block < system.layout().blockCount(); block++) {
                system.addStiffness(system.positions(), u, out, block);
            }
            for (int n : nodes) {
                trace += out[3 * n + axis];
            }
        }
        return (lightness - 1) / total() * trace;
    }
}
