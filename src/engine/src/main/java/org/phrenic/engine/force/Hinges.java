package org.phrenic.engine.force;

/**
 * Discrete bending of a triangulated surface: for each inner edge the four nodes a, b (its ends), c, d (opposite, in
 * the two triangles) and weights w, so that the energy of bending is
 *
 * <pre>
 * E = Σ |w_a x_a + w_b x_b + w_c x_c + w_d x_d|² / 2
 * </pre>
 *
 * <p>The weights are those of the quadratic bending energy of Bergou, Wardetzky, Harmon, Zorin and Grinspun (2006, doi
 * 10.2312/SGP/SGP06/227-230), scaled so that D is the stiffness against bending to a cylinder: on a lattice of
 * equilateral triangles the energy per area of a curvature κ in one direction is D κ² / 2, and that of κ in both 2/3 of
 * it twice (a plate of Poisson's ratio -1/3; Seung and Nelson 1988, doi 10.1103/PhysRevA.38.1005). With the cotangents
 * of the angles at the ends of the edge and A the area of both triangles,
 *
 * <pre>
 * w_c = -s (cot α_a + cot α_b),  w_d = -s (cot β_a + cot β_b),
 * w_a = s (cot α_b + cot β_b),   w_b = s (cot α_a + cot β_a),   s = √(D / A)
 * </pre>
 *
 * <p>α lies in the triangle of c, β in that of d. The weights of an edge sum to 0 and annul any linear map of a flat
 * hinge, so neither translation nor homogeneous strain of a plane costs energy.
 */
public final class Hinges {
    /** Number of nodes of a hinge. */
    static final int NODES = 4;

    private final int[] nodes;
    private final double[] weights;

    private Hinges(int[] nodes, double[] weights) {
        this.nodes = nodes;
        this.weights = weights;
    }

    /**
     * Hinges in their shape at rest.
     *
     * @param positions three numbers a node, mm
     * @param nodes four a hinge: both ends of the edge, then the opposite node in each triangle
     * @param stiffness bending stiffness D of each hinge, mN mm
     * @throws IllegalArgumentException if there are not four nodes for each stiffness, a stiffness is negative or not
     *     finite, or a triangle has no area
     */
    public static Hinges of(double[] positions, int[] nodes, double[] stiffness) {
        if (nodes.length != NODES * stiffness.length) {
            throw new IllegalArgumentException("hinges: found " + nodes.length + " nodes and " + stiffness.length
                    + " stiffnesses, expected four nodes each");
        }
        double[] weights = new double[nodes.length];
        for (int h = 0; h < stiffness.length; h++) {
            weigh(positions, nodes, NODES * h, stiffness[h], weights);
        }
        return new Hinges(nodes.clone(), weights);
    }

    private static void weigh(double[] p, int[] nodes, int at, double stiffness, double[] weights) {
        int a = nodes[at];
        int b = nodes[at + 1];
        double[] one = triangle(p, a, b, nodes[at + 2]);
        double[] other = triangle(p, a, b, nodes[at + 3]);
        double area = one[2] + other[2];
        if (!(one[2] > 0 && other[2] > 0) || !(stiffness >= 0) || Double.isInfinite(stiffness)) {
            throw new IllegalArgumentException(
                    "hinge " + at / NODES + ": found triangles of " + one[2] + " and " + other[2] + " mm² and "
                            + stiffness + " mN mm, expected areas and a stiffness that is not negative");
        }
        double s = Math.sqrt(stiffness / area);
        weights[at] = s * (one[1] + other[1]);
        weights[at + 1] = s * (one[0] + other[0]);
        weights[at + 2] = -s * (one[0] + one[1]);
        weights[at + 3] = -s * (other[0] + other[1]);
    }

    /** Cotangents of the angles at a and b of the triangle a, b, c, and its area. */
    private static double[] triangle(double[] p, int a, int b, int c) {
        double edge = 0;
        double along = 0;
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            double e = p[3 * b + axis] - p[3 * a + axis];
            double f = p[3 * c + axis] - p[3 * a + axis];
            edge += e * e;
            along += e * f;
            squared += f * f;
        }
        double doubleArea = Math.sqrt(Math.max(0, edge * squared - along * along));
        return new double[] {along / doubleArea, (edge - along) / doubleArea, 0.5 * doubleArea};
    }

    public int count() {
        return nodes.length / NODES;
    }

    /** Weights, four a hinge, √(N/m); read only. */
    double[] weights() {
        return weights;
    }

    /** Nodes, four a hinge; a copy. */
    public int[] corners() {
        return nodes.clone();
    }

    /**
     * Sum of the absolute stiffnesses in the row of each corner of each hinge, N/m. No eigenvalue exceeds the largest
     * sum over the corners at a node.
     */
    public double[] rowSums() {
        double[] sums = new double[weights.length];
        for (int i = 0; i < sums.length; i++) {
            int hinge = i / NODES * NODES;
            for (int c = hinge; c < hinge + NODES; c++) {
                sums[i] += Math.abs(weights[c]) * Math.abs(weights[i]);
            }
        }
        return sums;
    }
}
