package org.phrenic.motion;

/**
 * The inverse of a displacement field: the displacement w at y with {@code x + u(x) = y}, {@code w = x - y}. Found by
 * the fixed-point iteration {@code x <- x - s (x + u(x) - y)} (Chen, Lu, Chen, Ruchala and Olivera 2008, doi
 * 10.1118/1.2816107), s = 1, halved whenever a step makes the rest larger. It begins at the inverse that was found at
 * the nodes of a lattice and is refined {@value #REFINEMENTS} times at each place.
 */
final class InverseField implements RegionField {
    private static final int MOST_ITERATIONS = 60;
    private static final double TOLERANCE_MM = 1e-4;
    private static final int REFINEMENTS = 3;
    private static final double MARGIN_MM = 12;

    private final RegionField forward;
    private final VectorLattice start;

    /**
     * @param box of the places that will be asked for: three least, three greatest coordinates, mm
     * @param edge distance of the nodes at which the inverse is found first, mm
     */
    InverseField(RegionField forward, double[] box, double edge) {
        this.forward = forward;
        start = VectorLattice.covering(box, MARGIN_MM, edge);
    }

    /** Number of planes of nodes. */
    int planes() {
        return start.size[2];
    }

    /** Finds the inverse at the nodes of a plane. */
    void solvePlane(int plane) {
        int nodes = start.size[0] * start.size[1];
        double[] w = new double[3];
        double[] u = new double[3];
        for (int node = plane * nodes; node < (plane + 1) * nodes; node++) {
            double x = start.place(node, 0);
            double y = start.place(node, 1);
            double z = start.place(node, 2);
            // A row begins at 0, each further node at what the one before it found.
            if (node % start.size[0] == 0) {
                w[0] = 0;
                w[1] = 0;
                w[2] = 0;
            }
            iterate(x, y, z, w, u, MOST_ITERATIONS);
            System.arraycopy(w, 0, start.vectors, 3 * node, 3);
        }
    }

    private void iterate(double x, double y, double z, double[] w, double[] u, int most) {
        double before = Double.POSITIVE_INFINITY;
        double step = 1;
        for (int i = 0; i < most && before > TOLERANCE_MM * TOLERANCE_MM; i++) {
            forward.at(x + w[0], y + w[1], z + w[2], u);
            double a = w[0] + u[0];
            double b = w[1] + u[1];
            double c = w[2] + u[2];
            double left = a * a + b * b + c * c;
            step = left > before ? step / 2 : step;
            before = left;
            w[0] -= step * a;
            w[1] -= step * b;
            w[2] -= step * c;
        }
    }

    @Override
    public void at(double x, double y, double z, double[] out) {
        start.at(x, y, z, out);
        double a = out[0];
        double b = out[1];
        double c = out[2];
        for (int i = 0; i < REFINEMENTS; i++) {
            forward.at(x + a, y + b, z + c, out);
            double u = a + out[0];
            double v = b + out[1];
            double w = c + out[2];
            a -= u;
            b -= v;
            c -= w;
            if (u * u + v * v + w * w < TOLERANCE_MM * TOLERANCE_MM) {
                break;
            }
        }
        out[0] = a;
        out[1] = b;
        out[2] = c;
    }
}
