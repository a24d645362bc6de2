package org.phrenic.engine.force;

import java.util.Map;
import java.util.TreeMap;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * Resistance of a surface to bending away from its shape at rest x⁰, with the weights w of {@link Hinges}:
 *
 * <pre>
 * E = Σ |Σ_j w_j (x_j - x⁰_j)|² / 2,     f = -K (x - x⁰),     K_ij = Σ w_i w_j
 * </pre>
 *
 * <p>The energy is quadratic, so K is constant and positive semidefinite. It is one matrix for the three axes, held by
 * compressed rows. The curvature at rest keeps its direction in space: where the surface turns by an angle, its rest
 * curvature pulls by the sine of it. In a smooth surface these forces cancel, but for the bending stiffness times the
 * third power of the curvature.
 */
public final class HingeBending implements ForceField {
    /** Corners of a hinge. */
    private static final int CORNERS = 4;

    /** Rows of each block: those from one number to the next. */
    private final int[] blockStart;
    /** Node of each row, times 3. */
    private final int[] row;
    /** Entries of each row: those from one number to the next. */
    private final int[] start;
    /** Node of each entry, times 3. */
    private final int[] column;

    private final double[] value;
    /** K x⁰, three components a row. */
    private final double[] loadAtRest;

    private final double energyAtRest;
    /** K x¹, three components a row, and its product with x¹. */
    private final double[] loadKept;

    private double workKept;
    private double scale = 1;
    /** s K x¹ + K (x⁰ - x¹), three components a row. */
    private final double[] load;

    /**
     * @param layout layout of the system
     * @param hinges in the caller's numbering
     * @param rest positions of all nodes without bending force, caller's order, mm
     */
    public HingeBending(NodeLayout layout, Hinges hinges, double[] rest) {
        Map<Integer, Map<Integer, Double>> rows = assemble(layout, hinges);
        blockStart = new int[layout.blockCount() + 1];
        row = new int[rows.size()];
        start = new int[rows.size() + 1];
        int entries = rows.values().stream().mapToInt(Map::size).sum();
        column = new int[entries];
        value = new double[entries];
        int r = 0;
        int at = 0;
        for (Map.Entry<Integer, Map<Integer, Double>> line : rows.entrySet()) {
            row[r] = 3 * line.getKey();
            blockStart[layout.blockOf(line.getKey()) + 1]++;
            for (Map.Entry<Integer, Double> entry : line.getValue().entrySet()) {
                column[at] = 3 * entry.getKey();
                value[at++] = entry.getValue();
            }
            start[++r] = at;
        }
        for (int block = 0; block < layout.blockCount(); block++) {
            blockStart[block + 1] += blockStart[block];
        }
        loadAtRest = new double[3 * row.length];
        workKept = loads(layout.toInternal(rest), loadAtRest);
        energyAtRest = 0.5 * workKept;
        loadKept = loadAtRest.clone();
        load = loadAtRest.clone();
    }

    /** Computes K x of all rows; returns its product with x. */
    private double loads(double[] x, double[] out) {
        double work = 0;
        for (int i = 0; i < out.length; i++) {
            out[i] = product(x, i / 3, i % 3);
            work += out[i] * x[row[i / 3] + i % 3];
        }
        return work;
    }

    /**
     * Sets the stiffness to s times that of the hinges: {@code f = s K (x¹ - x) + K (x⁰ - x¹)}, so that the forces at
     * positions x¹ stay. Not while forces are computed.
     *
     * @param times s
     */
    public void setScale(double times) {
        scale = times;
        for (int i = 0; i < load.length; i++) {
            load[i] = times == 1 ? loadAtRest[i] : loadAtRest[i] + (times - 1) * loadKept[i];
        }
    }

    /**
     * Sets x¹, the positions at which forces stay when the scale changes; those at rest without it.
     *
     * @param positions of all nodes, internal order, mm
     */
    public void keepForcesAt(double[] positions) {
        workKept = loads(positions, loadKept);
        setScale(scale);
    }

    /** The rows of K by internal node, blocks in order; sums in the order of the hinges. */
    private static Map<Integer, Map<Integer, Double>> assemble(NodeLayout layout, Hinges hinges) {
        Map<Integer, Map<Integer, Double>> rows = new TreeMap<>();
        int[] corner = hinges.corners();
        double[] weight = hinges.weights();
        for (int i = 0; i < corner.length; i++) {
            Map<Integer, Double> entries = rows.computeIfAbsent(layout.internal(corner[i]), n -> new TreeMap<>());
            int hinge = i / CORNERS * CORNERS;
            for (int j = hinge; j < hinge + CORNERS; j++) {
                entries.merge(layout.internal(corner[j]), weight[i] * weight[j], Double::sum);
            }
        }
        return rows;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        int end = blockStart[block + 1];
        for (int from = blockStart[block]; from < end; from += NodeLayout.LOOP_CHUNK) {
            subtractProduct(x, force, from, Math.min(end, from + NodeLayout.LOOP_CHUNK));
        }
        for (int i = blockStart[block]; i < end; i++) {
            SpringKernel.add(force, row[i], load[3 * i], load[3 * i + 1], load[3 * i + 2]);
        }
    }

    /** Subtracts K x from the rows of a range. */
    private void subtractProduct(double[] x, double[] out, int from, int end) {
        int[] columns = column;
        double[] k = value;
        for (int i = from; i < end; i++) {
            double sumX = 0;
            double sumY = 0;
            double sumZ = 0;
            int last = start[i + 1];
            for (int e = start[i]; e < last; e++) {
                double stiffness = k[e];
                int j = columns[e];
                sumX += stiffness * x[j];
                sumY += stiffness * x[j + 1];
                sumZ += stiffness * x[j + 2];
            }
            SpringKernel.add(out, row[i], -scale * sumX, -scale * sumY, -scale * sumZ);
        }
    }

    /** K u is minus the force that would be at the positions u. */
    @Override
    public void addStiffness(double[] x, double[] u, double[] out, int block) {
        for (int i = blockStart[block]; i < blockStart[block + 1]; i++) {
            for (int axis = 0; axis < 3; axis++) {
                out[row[i] + axis] += scale * product(u, i, axis);
            }
        }
    }

    private double product(double[] u, int i, int axis) {
        double sum = 0;
        for (int e = start[i]; e < start[i + 1]; e++) {
            sum += value[e] * u[column[e] + axis];
        }
        return sum;
    }

    @Override
    public void addRowSums(double[] x, double[] stiffness, double[] damping) {
        for (int i = 0; i < row.length; i++) {
            for (int e = start[i]; e < start[i + 1]; e++) {
                stiffness[row[i] / 3] += scale * Math.abs(value[e]);
            }
        }
    }

    @Override
    public double potentialEnergy(double[] x) {
        double sum = energyAtRest + 0.5 * (scale - 1) * workKept;
        for (int i = 0; i < row.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                sum += (0.5 * scale * product(x, i, axis) - load[3 * i + axis]) * x[row[i] + axis];
            }
        }
        return sum;
    }
}
