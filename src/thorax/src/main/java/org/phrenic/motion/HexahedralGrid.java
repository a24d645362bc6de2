package org.phrenic.motion;

import java.util.Arrays;
import java.util.function.ToDoubleFunction;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SurfaceDistance;

/**
 * Trilinear hexahedra of a regular grid that cover a body, with the stiffness of a homogeneous, linearly elastic solid
 * of Young's modulus 1. A cell is weighted by the share of it that lies inside the body. Displacements are arrays of
 * three numbers a node, mm.
 */
final class HexahedralGrid {
    private static final int CORNERS = 8;
    private static final int DOF = 3 * CORNERS;

    /** A point in a cell: the cell's nodes, and the weight of each. */
    record Place(int[] nodes, double[] weights) {}

    private final double edge;
    private final double poisson;
    private final double[] low = new double[3];
    private final int[] cells = new int[3];
    /** For each place of the grid: number of its cell among those kept, or -1. */
    private final int[] kept;

    private int[] nodes = new int[0];
    private double[] share = new double[0];
    private final double[][] stiffness;
    private final int nodeCount;

    /**
     * @param edge edge of a cell, mm
     * @param samples points along each edge of a cell at which inside and outside are told apart
     * @param least least weight of a cell that holds a vertex
     */
    HexahedralGrid(TriangleMesh body, double edge, int samples, double least, double poisson) {
        this.edge = edge;
        this.poisson = poisson;
        double[] box = body.bounds();
        int total = 1;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = box[axis] - edge / 2;
            cells[axis] = (int) Math.ceil((box[3 + axis] + edge / 2 - low[axis]) / edge);
            total *= cells[axis];
        }
        double[] shares = shares(body, total, samples);
        for (int v = 0; v < body.vertexCount(); v++) {
            int cell = cell(new double[] {body.x(v), body.y(v), body.z(v)});
            shares[cell] = Math.max(shares[cell], least);
        }
        kept = new int[total];
        Arrays.fill(kept, -1);
        nodeCount = number(shares);
        stiffness = stiffness(edge, poisson);
    }

    /** Share of each place of the grid that lies inside the body. */
    private double[] shares(TriangleMesh body, int total, int samples) {
        int each = samples * samples * samples;
        double[] points = new double[3 * total * each];
        for (int p = 0; p < total * each; p++) {
            int[] at = coordinates(p / each);
            int s = p % each;
            int[] within = {s % samples, s / samples % samples, s / samples / samples};
            for (int axis = 0; axis < 3; axis++) {
                points[3 * p + axis] = low[axis] + edge * (at[axis] + (within[axis] + 0.5) / samples);
            }
        }
        double[] depth = new SurfaceDistance(body).sidedDistance(points);
        double[] shares = new double[total];
        for (int p = 0; p < depth.length; p++) {
            shares[p / each] += depth[p] < 0 ? 1.0 / each : 0;
        }
        return shares;
    }

    /** Numbers the cells that are kept and their nodes. Returns the number of nodes. */
    private int number(double[] shares) {
        int[] ids = new int[(cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1)];
        Arrays.fill(ids, -1);
        int count = (int) Arrays.stream(shares).filter(s -> s > 0).count();
        nodes = new int[CORNERS * count];
        share = new double[count];
        int next = 0;
        int cell = 0;
        for (int place = 0; place < shares.length; place++) {
            if (shares[place] <= 0) {
                continue;
            }
            int[] at = coordinates(place);
            for (int c = 0; c < CORNERS; c++) {
                int id =
                        at[0] + (c & 1) + (cells[0] + 1) * (at[1] + (c >> 1 & 1) + (cells[1] + 1) * (at[2] + (c >> 2)));
                ids[id] = ids[id] < 0 ? next++ : ids[id];
                nodes[CORNERS * cell + c] = ids[id];
            }
            share[cell] = shares[place];
            kept[place] = cell++;
        }
        return next;
    }

    private int[] coordinates(int place) {
        return new int[] {place % cells[0], place / cells[0] % cells[1], place / cells[0] / cells[1]};
    }

    private int cell(double[] point) {
        int[] at = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = Math.max(0, Math.min(cells[axis] - 1, (int) Math.floor((point[axis] - low[axis]) / edge)));
        }
        return at[0] + cells[0] * (at[1] + cells[1] * at[2]);
    }

    /** Length of a displacement. */
    int length() {
        return 3 * nodeCount;
    }

    /** The cell that holds a point; for a point outside all cells the nearest, whose field goes on linearly. */
    Place locate(double[] point) {
        int place = cell(point);
        if (kept[place] < 0) {
            place = nearest(point);
        }
        int[] at = coordinates(place);
        double[] weights = new double[CORNERS];
        for (int c = 0; c < CORNERS; c++) {
            weights[c] = 1;
            for (int axis = 0; axis < 3; axis++) {
                double t = (point[axis] - low[axis]) / edge - at[axis];
                weights[c] *= (c >> axis & 1) == 1 ? t : 1 - t;
            }
        }
        return new Place(Arrays.copyOfRange(nodes, CORNERS * kept[place], CORNERS * (kept[place] + 1)), weights);
    }

    private int nearest(double[] point) {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int place = 0; place < kept.length; place++) {
            if (kept[place] >= 0) {
                int[] at = coordinates(place);
                double squared = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double d = point[axis] - low[axis] - edge * (at[axis] + 0.5);
                    squared += d * d;
                }
                if (squared < least) {
                    least = squared;
                    best = place;
                }
            }
        }
        return best;
    }

    double[] interpolate(Place place, double[] displacement) {
        double[] u = new double[3];
        for (int c = 0; c < CORNERS; c++) {
            for (int axis = 0; axis < 3; axis++) {
                u[axis] += place.weights()[c] * displacement[3 * place.nodes()[c] + axis];
            }
        }
        return u;
    }

    /** Adds a force at a place to the forces at its nodes. */
    void scatter(Place place, double[] force, double[] out) {
        for (int c = 0; c < CORNERS; c++) {
            for (int axis = 0; axis < 3; axis++) {
                out[3 * place.nodes()[c] + axis] += place.weights()[c] * force[axis];
            }
        }
    }

    /** Elastic forces of a displacement. */
    void multiply(double[] displacement, double[] out) {
        Arrays.fill(out, 0);
        double[] x = new double[DOF];
        for (int cell = 0; cell < share.length; cell++) {
            for (int k = 0; k < DOF; k++) {
                x[k] = share[cell] * displacement[3 * nodes[CORNERS * cell + k / 3] + k % 3];
            }
            for (int k = 0; k < DOF; k++) {
                double sum = 0;
                for (int j = 0; j < DOF; j++) {
                    sum += stiffness[k][j] * x[j];
                }
                out[3 * nodes[CORNERS * cell + k / 3] + k % 3] += sum;
            }
        }
    }

    /**
     * Forces at the nodes of a solid that would expand freely by a linear strain in all directions: {@code e / (1 - 2
     * nu)} times the integral of each shape function's gradient, e taken at the middle of each cell.
     *
     * @param strain free strain, as a function of the place in mm
     */
    double[] expansion(ToDoubleFunction<double[]> strain) {
        double[] out = new double[length()];
        double[] middle = new double[3];
        for (int place = 0; place < kept.length; place++) {
            int cell = kept[place];
            if (cell < 0) {
                continue;
            }
            int[] at = coordinates(place);
            for (int axis = 0; axis < 3; axis++) {
                middle[axis] = low[axis] + edge * (at[axis] + 0.5);
            }
            double force = share[cell] * strain.applyAsDouble(middle) / (1 - 2 * poisson) * edge * edge / 4;
            for (int k = 0; k < DOF; k++) {
                int corner = k / 3;
                boolean high = (corner >> (k % 3) & 1) == 1;
                out[3 * nodes[CORNERS * cell + corner] + k % 3] += high ? force : -force;
            }
        }
        return out;
    }

    /** Diagonal of the stiffness. */
    double[] diagonal() {
        double[] out = new double[length()];
        for (int k = 0; k < share.length * DOF; k++) {
            out[3 * nodes[k / 3] + k % 3] += share[k / DOF] * stiffness[k % DOF][k % DOF];
        }
        return out;
    }

    /** Stiffness of a cube, integrated at two Gauss points an axis: sum of lambda div div + 2 mu eps : eps. */
    private static double[][] stiffness(double edge, double poisson) {
        double lambda = poisson / ((1 + poisson) * (1 - 2 * poisson));
        double mu = 0.5 / (1 + poisson);
        double[][] k = new double[DOF][DOF];
        double gauss = 1 / Math.sqrt(3);
        for (int g = 0; g < CORNERS; g++) {
            double[][] slope = new double[CORNERS][3];
            for (int c = 0; c < CORNERS; c++) {
                for (int axis = 0; axis < 3; axis++) {
                    slope[c][axis] = 2 / edge;
                    for (int other = 0; other < 3; other++) {
                        double sign = (c >> other & 1) == 1 ? 0.5 : -0.5;
                        double at = (g >> other & 1) == 1 ? gauss : -gauss;
                        slope[c][axis] *= other == axis ? sign : 0.5 + sign * at;
                    }
                }
            }
            double volume = edge * edge * edge / CORNERS;
            for (int a = 0; a < DOF; a++) {
                for (int b = 0; b < DOF; b++) {
                    double[] p = slope[a / 3];
                    double[] q = slope[b / 3];
                    double dot = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
                    k[a][b] += volume
                            * (lambda * p[a % 3] * q[b % 3] + mu * (p[b % 3] * q[a % 3] + (a % 3 == b % 3 ? dot : 0)));
                }
            }
        }
        return k;
    }
}
