package org.phrenic.engine.equilibrium;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.engine.Constraint;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.math.DisjointSets;

/**
 * The active rows C of a system's constraints and the projection onto their null space, P = 1 - Cᵀ (C Cᵀ)⁻¹ C. Rows
 * that share a free node form a group, which is solved by Cholesky factorisation. Groups are small. Rows that depend
 * linearly on others of their group are left out.
 */
final class ActiveConstraints implements Constraint.RowConsumer {
    /** Fraction of a row's squared norm below which its remainder counts as linearly dependent. */
    private static final double NEW = 1e-6;

    private final ParticleSystem system;
    private final boolean[] isFree;
    private int count;
    private int[] nodeA = new int[64];
    private int[] nodeB = new int[64];
    private double[] normal = new double[192];
    private double[] gap = new double[64];
    private boolean[] oneSided = new boolean[64];
    private boolean[] active = new boolean[64];
    /** Groups of rows: where each begins in {@code member}, and its lower Cholesky factor, row by row. */
    private int[] start = {0};

    private int[] member = {};
    private double[][] factor = {};
    private double[] value = {};

    /** @param isFree for each internal node, whether it may move */
    ActiveConstraints(ParticleSystem system, boolean[] isFree) {
        this.system = system;
        this.isFree = isFree;
    }

    /** Collects all rows at the current state with the constraints' current normals. The active set is kept. */
    void collect() {
        count = 0;
        for (Constraint constraint : system.constraints()) {
            constraint.jacobianRows(system, this);
        }
    }

    @Override
    public void add(int a, int b, double nx, double ny, double nz, double distance, boolean oneWay) {
        if (count == gap.length) {
            int more = 2 * count;
            nodeA = Arrays.copyOf(nodeA, more);
            nodeB = Arrays.copyOf(nodeB, more);
            normal = Arrays.copyOf(normal, 3 * more);
            gap = Arrays.copyOf(gap, more);
            oneSided = Arrays.copyOf(oneSided, more);
            active = Arrays.copyOf(active, more);
        }
        nodeA[count] = a;
        nodeB[count] = b;
        normal[3 * count] = nx;
        normal[3 * count + 1] = ny;
        normal[3 * count + 2] = nz;
        gap[count] = distance;
        oneSided[count] = oneWay;
        active[count] |= !oneWay;
        count++;
    }

    /**
     * Updates the active set: rows nearer than a distance become active, rows that would pull more than a force are
     * released.
     *
     * @param multiplier of each row, negative where nodes press; null if not known
     * @return how many rows changed
     */
    int updateActiveSet(double nearMm, double[] multiplier, double pullMn) {
        int changed = 0;
        for (int i = 0; i < count; i++) {
            boolean before = active[i];
            boolean now = !oneSided[i] || ((before && multiplier != null) ? multiplier[i] <= pullMn : gap[i] < nearMm);
            active[i] = now;
            changed += now == before ? 0 : 1;
        }
        return changed;
    }

    /** Number of active rows. */
    int activeCount() {
        return (int) IntStream.range(0, count).filter(i -> active[i]).count();
    }

    /** Groups the active rows and factorises each group. */
    void factorise() {
        int[] group = groups();
        List<Integer> order = IntStream.range(0, count)
                .filter(i -> active[i] && group[i] >= 0)
                .boxed()
                .sorted(Comparator.comparingInt(i -> group[i]))
                .toList();
        List<Integer> starts = new ArrayList<>();
        List<Integer> members = new ArrayList<>();
        List<double[]> factors = new ArrayList<>();
        for (int from = 0; from < order.size(); ) {
            int to = from;
            while (to < order.size() && group[order.get(to)] == group[order.get(from)]) {
                to++;
            }
            starts.add(members.size());
            factors.add(factor(order.subList(from, to), members));
            from = to;
        }
        starts.add(members.size());
        start = starts.stream().mapToInt(Integer::intValue).toArray();
        member = members.stream().mapToInt(Integer::intValue).toArray();
        factor = factors.toArray(double[][]::new);
        value = new double[count];
    }

    /** The group of each row, by shared free nodes; -1 where both ends are prescribed. */
    private int[] groups() {
        int[] parent = DisjointSets.singletons(isFree.length);
        for (int i = 0; i < count; i++) {
            if (active[i] && nodeB[i] >= 0 && isFree[nodeA[i]] && isFree[nodeB[i]]) {
                parent[DisjointSets.find(parent, nodeA[i])] = DisjointSets.find(parent, nodeB[i]);
            }
        }
        int[] group = new int[count];
        for (int i = 0; i < count; i++) {
            boolean byB = !isFree[nodeA[i]];
            boolean none = byB && (nodeB[i] < 0 || !isFree[nodeB[i]]);
            group[i] = none ? -1 : DisjointSets.find(parent, byB ? nodeB[i] : nodeA[i]);
        }
        return group;
    }

    /** Lower Cholesky factor of C Cᵀ of the linearly independent rows, which are appended to {@code members}. */
    private double[] factor(List<Integer> rows, List<Integer> members) {
        int from = members.size();
        double[][] lower = new double[rows.size()][];
        int kept = 0;
        for (int row : rows) {
            double[] line = new double[kept + 1];
            double left = product(row, row);
            double whole = left;
            for (int j = 0; j < kept; j++) {
                double sum = product(row, members.get(from + j));
                for (int k = 0; k < j; k++) {
                    sum -= line[k] * lower[j][k];
                }
                line[j] = sum / lower[j][j];
                left -= line[j] * line[j];
            }
            if (left > NEW * whole) {
                line[kept] = Math.sqrt(left);
                lower[kept++] = line;
                members.add(row);
            }
        }
        double[] flat = new double[kept * kept];
        for (int i = 0; i < kept; i++) {
            System.arraycopy(lower[i], 0, flat, kept * i, i + 1);
        }
        return flat;
    }

    private double product(int p, int q) {
        double cosine = normal[3 * p] * normal[3 * q]
                + normal[3 * p + 1] * normal[3 * q + 1]
                + normal[3 * p + 2] * normal[3 * q + 2];
        int shared = 0;
        shared += isFree[nodeA[p]] && nodeA[p] == nodeA[q] ? 1 : 0;
        shared += nodeB[p] >= 0 && isFree[nodeB[p]] && nodeB[p] == nodeB[q] ? 1 : 0;
        shared -= isFree[nodeA[p]] && nodeA[p] == nodeB[q] ? 1 : 0;
        shared -= nodeB[p] >= 0 && isFree[nodeB[p]] && nodeB[p] == nodeA[q] ? 1 : 0;
        return shared * cosine;
    }

    /** λ = (C Cᵀ)⁻¹ C u, one value a row, 0 for inactive rows; valid until the next call. */
    double[] multipliers(double[] u) {
        Arrays.fill(value, 0);
        for (int i : member) {
            value[i] = along(i, u);
        }
        solve();
        return value;
    }

    private double along(int i, double[] u) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = isFree[nodeA[i]] ? u[3 * nodeA[i] + axis] : 0;
            if (nodeB[i] >= 0 && isFree[nodeB[i]]) {
                d -= u[3 * nodeB[i] + axis];
            }
            sum += normal[3 * i + axis] * d;
        }
        return sum;
    }

    private void solve() {
        for (int g = 0; g < factor.length; g++) {
            double[] lower = factor[g];
            int first = start[g];
            int m = start[g + 1] - first;
            for (int i = 0; i < m; i++) {
                double sum = value[member[first + i]];
                for (int k = 0; k < i; k++) {
                    sum -= lower[m * i + k] * value[member[first + k]];
                }
                value[member[first + i]] = sum / lower[m * i + i];
            }
            for (int i = m - 1; i >= 0; i--) {
                double sum = value[member[first + i]];
                for (int k = i + 1; k < m; k++) {
                    sum -= lower[m * k + i] * value[member[first + k]];
                }
                value[member[first + i]] = sum / lower[m * i + i];
            }
        }
    }

    /** Projects u onto the null space of the active rows: u ← P u. Entries of nodes that are not free become 0. */
    void project(double[] u) {
        for (int n = 0; n < isFree.length; n++) {
            if (!isFree[n]) {
                Arrays.fill(u, 3 * n, 3 * n + 3, 0);
            }
        }
        addForces(multipliers(u), -1, u);
    }

    /** Adds a multiple of Cᵀ λ with the current normals. */
    void addForces(double[] lambda, double times, double[] out) {
        for (int i : member) {
            for (int axis = 0; axis < 3; axis++) {
                double f = times * lambda[i] * normal[3 * i + axis];
                if (isFree[nodeA[i]]) {
                    out[3 * nodeA[i] + axis] += f;
                }
                if (nodeB[i] >= 0 && isFree[nodeB[i]]) {
                    out[3 * nodeB[i] + axis] -= f;
                }
            }
        }
    }

    /** Moves nodes by the smallest displacement for which the active rows hold: x ← x - Cᵀ (C Cᵀ)⁻¹ gap. */
    void projectPositions(double[] x) {
        Arrays.fill(value, 0);
        for (int i : member) {
            value[i] = gap[i];
        }
        solve();
        addForces(value, -1, x);
    }
}
