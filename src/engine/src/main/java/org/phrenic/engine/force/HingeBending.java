package org.phrenic.engine.force;

import java.util.Arrays;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * Resistance of a surface to bending away from its shape at rest x⁰, with the weights w of {@link Hinges}:
 *
 * <pre>
 * E = Σ |Σ_j w_j (x_j - x⁰_j)|² / 2,     f_i = -w_i Σ_j w_j (x_j - x⁰_j)
 * </pre>
 *
 * <p>The energy is quadratic, so K is constant and positive semidefinite. The curvature at rest keeps its direction in
 * space: where the surface turns by an angle, its rest curvature pulls by the sine of it. In a smooth surface these
 * forces cancel, but for the bending stiffness times the third power of the curvature.
 */
public final class HingeBending implements ForceField {
    /** Bits of the corners of a hinge that lie in the block. */
    private static final int CORNERS = 4;

    /** Entries in one call: short calls are compiled sooner. */
    private static final int CHUNK = 256;

    private final int[] start;
    /** Nodes times 3, four an entry. */
    private final int[] node;
    /** Weights of the last three nodes of each entry; that of the first is minus their sum. */
    private final double[] weight;

    private final int[] owned;
    /** The force at x = 0, which makes the shape at rest the one without force. */
    private final ConstantLoad atRest;

    private final double energyAtRest;

    /**
     * @param layout layout of the system
     * @param hinges in the caller's numbering
     * @param rest positions of all nodes without bending force, caller's order, mm
     */
    public HingeBending(NodeLayout layout, Hinges hinges, double[] rest) {
        int[] internal = Arrays.stream(hinges.corners()).map(layout::internal).toArray();
        long[] key = keys(layout, internal);
        start = new int[layout.blockCount() + 1];
        node = new int[CORNERS * key.length];
        weight = new double[3 * key.length];
        owned = new int[key.length];
        for (int i = 0; i < key.length; i++) {
            int block = (int) (key[i] >>> 32);
            int from = CORNERS * (int) key[i];
            start[block + 1]++;
            for (int c = 0; c < CORNERS; c++) {
                node[CORNERS * i + c] = 3 * internal[from + c];
                owned[i] |= layout.blockOf(internal[from + c]) == block ? 1 << c : 0;
            }
            System.arraycopy(hinges.weights(), from + 1, weight, 3 * i, 3);
        }
        Arrays.parallelPrefix(start, Integer::sum);
        double[] x = layout.toInternal(rest);
        double[] pull = new double[x.length];
        for (int block = 0; block < layout.blockCount(); block++) {
            bend(x, pull, block);
        }
        double[] load = new double[x.length];
        layout.toCaller(pull, load);
        Arrays.setAll(load, i -> -load[i]);
        atRest = new ConstantLoad(layout, load);
        energyAtRest = -0.5 * atRest.potentialEnergy(x);
    }

    /** The block and the number of each hinge, once for each block that has a corner of it, in order. */
    private static long[] keys(NodeLayout layout, int[] internal) {
        long[] key = new long[internal.length];
        int entries = 0;
        for (int i = 0; i < internal.length; i++) {
            long next = (long) layout.blockOf(internal[i]) << 32 | i / CORNERS;
            boolean isNew = true;
            for (int k = entries - 1; isNew && k >= 0 && (int) key[k] == i / CORNERS; k--) {
                isNew = key[k] != next;
            }
            if (isNew) {
                key[entries++] = next;
            }
        }
        key = Arrays.copyOf(key, entries);
        RadixSort.sort(key);
        return key;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        bend(x, force, block);
        atRest.addForces(x, v, force, block);
    }

    private void bend(double[] x, double[] force, int block) {
        int end = start[block + 1];
        for (int from = start[block]; from < end; from += CHUNK) {
            bend(x, force, from, Math.min(end, from + CHUNK));
        }
    }

    private void bend(double[] x, double[] force, int from, int end) {
        int[] nodes = node;
        double[] w = weight;
        int[] mask = owned;
        for (int i = from; i < end; i++) {
            int a = nodes[CORNERS * i];
            int b = nodes[CORNERS * i + 1];
            int c = nodes[CORNERS * i + 2];
            int d = nodes[CORNERS * i + 3];
            double wb = w[3 * i];
            double wc = w[3 * i + 1];
            double wd = w[3 * i + 2];
            double wa = -(wb + wc + wd);
            double bx = wa * x[a] + wb * x[b] + wc * x[c] + wd * x[d];
            double by = wa * x[a + 1] + wb * x[b + 1] + wc * x[c + 1] + wd * x[d + 1];
            double bz = wa * x[a + 2] + wb * x[b + 2] + wc * x[c + 2] + wd * x[d + 2];
            int mine = mask[i];
            if ((mine & 1) != 0) {
                SpringKernel.add(force, a, -wa * bx, -wa * by, -wa * bz);
            }
            if ((mine & 2) != 0) {
                SpringKernel.add(force, b, -wb * bx, -wb * by, -wb * bz);
            }
            if ((mine & 4) != 0) {
                SpringKernel.add(force, c, -wc * bx, -wc * by, -wc * bz);
            }
            if ((mine & 8) != 0) {
                SpringKernel.add(force, d, -wd * bx, -wd * by, -wd * bz);
            }
        }
    }

    /** K u is minus the force that would be at the positions u. */
    @Override
    public void addStiffness(double[] x, double[] u, double[] out, int block) {
        for (int i = start[block]; i < start[block + 1]; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double b = bendAlong(u, i, axis);
                for (int c = 0; c < CORNERS; c++) {
                    if ((owned[i] >> c & 1) != 0) {
                        out[node[CORNERS * i + c] + axis] += weightOf(i, c) * b;
                    }
                }
            }
        }
    }

    private double weightOf(int entry, int corner) {
        return corner > 0
                ? weight[3 * entry + corner - 1]
                : -(weight[3 * entry] + weight[3 * entry + 1] + weight[3 * entry + 2]);
    }

    private double bendAlong(double[] x, int entry, int axis) {
        double sum = 0;
        for (int c = 0; c < CORNERS; c++) {
            sum += weightOf(entry, c) * x[node[CORNERS * entry + c] + axis];
        }
        return sum;
    }

    @Override
    public void addRowSums(double[] stiffness, double[] damping) {
        for (int i = 0; i < owned.length; i++) {
            double all = 0;
            for (int c = 0; c < CORNERS; c++) {
                all += Math.abs(weightOf(i, c));
            }
            for (int c = 0; c < CORNERS; c++) {
                if ((owned[i] >> c & 1) != 0) {
                    stiffness[node[CORNERS * i + c] / 3] += all * Math.abs(weightOf(i, c));
                }
            }
        }
    }

    @Override
    public double potentialEnergy(double[] x) {
        double sum = energyAtRest + atRest.potentialEnergy(x);
        for (int i = 0; i < owned.length; i++) {
            // A hinge in several blocks counts in that of its first node alone.
            for (int axis = 0; axis < 3 && (owned[i] & 1) != 0; axis++) {
                double b = bendAlong(x, i, axis);
                sum += 0.5 * b * b;
            }
        }
        return sum;
    }
}
