package org.phrenic.motion;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.phrenic.engine.math.ConjugateGradient;
import org.phrenic.mesh.IntList;

/**
 * Displacements that are given on surfaces, extended through space as smoothly as can be:
 *
 * <pre>  minimise  1/2 ∫ |∇u|² dV + 1/2 Σ (c a_i / h) |u(X_i) - v_i|²</pre>
 *
 * over the active nodes of a lattice with edge h, for surface points X_i with area a_i and displacement v_i, c =
 * {@value #HOLD}. Between the surfaces u is harmonic: no component of it has a maximum away from them. Where active
 * nodes end without a surface the gradient across the border is 0, so that a side that is left out has no say. Surface
 * points closer together than half an edge count as one. Discretised by differences between neighbouring nodes (seven
 * points), solved by conjugate gradients. Source: Joshi, Meyer, DeRose, Green and Sanocki 2007, Harmonic coordinates
 * for character articulation, doi 10.1145/1276377.1276466.
 */
final class HarmonicExtension {
    private static final double HOLD = 20;
    private static final double TOLERANCE = 1e-4;
    private static final int MOST_ITERATIONS = 400;
    private static final int CORNERS = 8;
    private static final int KEPT_LAYERS = 3;

    private final VectorLattice lattice;
    /** Node of each unknown. */
    private final int[] nodes;
    /** Up to six neighbours of each unknown, -1 for none. */
    private final int[] neighbours;

    private final int[] points;
    private final int[] corners;
    private final double[] weights;
    private final double[] hold;
    private final double[] diagonal;
    private final VectorLattice.Extension extension;
    private final Equations equations;

    /**
     * @param active nodes that are solved for
     * @param places surface points, as x, y, z triples, mm; those beside the active nodes are left out
     * @param areas area of each of them, mm^2
     * @param sliding number of places at the end of the list that hold the horizontal components alone
     * @param faded layers of nodes over which the field fades beyond the active ones; 0 for no fading
     */
    HarmonicExtension(
            VectorLattice lattice, boolean[] active, double[] places, double[] areas, int sliding, int faded) {
        this.lattice = lattice;
        int[] number = new int[active.length];
        IntList list = new IntList();
        for (int node = 0; node < active.length; node++) {
            number[node] = active[node] ? list.size() : -1;
            if (active[node]) {
                list.add(node);
            }
        }
        nodes = list.toArray();
        points = thinned(places, active);
        corners = new int[CORNERS * points.length];
        weights = new double[CORNERS * points.length];
        hold = new double[3 * points.length];
        double[] share = new double[3];
        for (int i = 0; i < points.length; i++) {
            int p = 3 * points[i];
            int cell = lattice.cell(places[p], places[p + 1], places[p + 2], share);
            Arrays.fill(hold, 3 * i, 3 * i + 3, HOLD * areas[points[i]] / lattice.edge);
            hold[3 * i + 2] *= points[i] < areas.length - sliding ? 1 : 0;
            for (int c = 0; c < CORNERS; c++) {
                corners[CORNERS * i + c] = number[lattice.corner(cell, c)];
                weights[CORNERS * i + c] = VectorLattice.weight(share, c);
            }
        }
        neighbours = new int[6 * nodes.length];
        diagonal = new double[nodes.length];
        for (int n = 0; n < neighbours.length; n++) {
            int other = lattice.neighbour(nodes[n / 6], n % 6);
            neighbours[n] = other < 0 ? -1 : number[other];
            diagonal[n / 6] += neighbours[n] < 0 ? 0 : lattice.edge;
        }
        for (int n = 0; n < nodes.length; n++) {
            // A node without neighbours and surface keeps 0.
            diagonal[n] += 1e-9 * lattice.edge;
        }
        extension = new VectorLattice.Extension(lattice, active, faded == 0 ? Integer.MAX_VALUE : KEPT_LAYERS, faded);
        equations = new Equations();
    }

    /** The first point in each cube of half an edge whose cell has active corners only. */
    private int[] thinned(double[] places, boolean[] active) {
        Set<Long> taken = new HashSet<>();
        IntList kept = new IntList();
        double[] share = new double[3];
        for (int i = 0; i < places.length / 3; i++) {
            int cell = lattice.cell(places[3 * i], places[3 * i + 1], places[3 * i + 2], share);
            boolean held = true;
            for (int c = 0; c < CORNERS; c++) {
                held &= active[lattice.corner(cell, c)];
            }
            int octant = (share[0] < 0.5 ? 0 : 1) + (share[1] < 0.5 ? 0 : 2) + (share[2] < 0.5 ? 0 : 4);
            if (held && taken.add((long) CORNERS * cell + octant)) {
                kept.add(i);
            }
        }
        return kept.toArray();
    }

    /** Solves for the vectors of the lattice; its present ones are the first guess. */
    void solve(double[] displacements) {
        double[] x = new double[3 * nodes.length];
        for (int n = 0; n < nodes.length; n++) {
            System.arraycopy(lattice.vectors, 3 * nodes[n], x, 3 * n, 3);
        }
        double[] right = new double[x.length];
        double[] pull = new double[3];
        for (int i = 0; i < points.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                pull[axis] = hold[3 * i + axis] * displacements[3 * points[i] + axis];
            }
            scatter(i, pull, right);
        }
        double[] residual = new double[x.length];
        double[] product = new double[x.length];
        equations.multiply(x, product);
        double goal = 0;
        for (int k = 0; k < x.length; k++) {
            residual[k] = right[k] - product[k];
            goal += right[k] * right[k] * equations.inverse[k / 3];
        }
        equations.start(residual);
        equations.solve(x, residual, goal * TOLERANCE * TOLERANCE, MOST_ITERATIONS);
        for (int n = 0; n < nodes.length; n++) {
            System.arraycopy(x, 3 * n, lattice.vectors, 3 * nodes[n], 3);
        }
        extend();
    }

    /** Lets the vectors of the active nodes go on beyond them. */
    void extend() {
        extension.apply(lattice.vectors);
    }

    private void scatter(int point, double[] vector, double[] out) {
        for (int c = CORNERS * point; c < CORNERS * (point + 1); c++) {
            int at = 3 * corners[c];
            out[at] += weights[c] * vector[0];
            out[at + 1] += weights[c] * vector[1];
            out[at + 2] += weights[c] * vector[2];
        }
    }

    private final class Equations extends ConjugateGradient {
        private final double[] inverse;
        private final double[] sum = new double[3];

        Equations() {
            super(3 * nodes.length, 3 * nodes.length);
            inverse = diagonal.clone();
            for (int c = 0; c < corners.length; c++) {
                inverse[corners[c]] += hold[3 * (c / CORNERS)] * weights[c] * weights[c];
            }
            for (int n = 0; n < inverse.length; n++) {
                inverse[n] = 1 / inverse[n];
            }
        }

        @Override
        protected void multiply(double[] d, double[] out) {
            for (int n = 0; n < nodes.length; n++) {
                double x = diagonal[n] * d[3 * n];
                double y = diagonal[n] * d[3 * n + 1];
                double z = diagonal[n] * d[3 * n + 2];
                for (int side = 6 * n; side < 6 * n + 6; side++) {
                    int other = 3 * neighbours[side];
                    if (other >= 0) {
                        x -= lattice.edge * d[other];
                        y -= lattice.edge * d[other + 1];
                        z -= lattice.edge * d[other + 2];
                    }
                }
                out[3 * n] = x;
                out[3 * n + 1] = y;
                out[3 * n + 2] = z;
            }
            for (int i = 0; i < points.length; i++) {
                Arrays.fill(sum, 0);
                for (int c = CORNERS * i; c < CORNERS * (i + 1); c++) {
                    int at = 3 * corners[c];
                    for (int axis = 0; axis < 3; axis++) {
                        sum[axis] += hold[3 * i + axis] * weights[c] * d[at + axis];
                    }
                }
                scatter(i, sum, out);
            }
        }

        @Override
        protected void precondition(double[] residual, double[] out) {
            for (int k = 0; k < residual.length; k++) {
                out[k] = inverse[k / 3] * residual[k];
            }
        }
    }
}
