package org.phrenic.model.organ;

import java.util.Arrays;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Indentation of a soft organ by objects that penetrate it, in the organ's rest frame. A regular grid stores the signed
 * distance to the surface. A penetrating point displaces the surface along the distance gradient, and the displacement
 * {@code D} of the grid nodes spreads to their neighbours and decays with distance:
 *
 * <p>{@code D ← (W T + λ D̄) / (W + λ (1 + μ))}, where {@code T} is the displacement requested near a node, {@code W ≤
 * 1} its weight and {@code D̄} the mean of the six neighbours. The decay length is {@code √(1/(6 μ))} times the grid
 * spacing.
 *
 * <p>This is a change of shape only: it exerts no force and does not conserve volume. Nothing is allocated after
 * construction.
 */
final class LiverIndentation {
    private static final double SPACING_MM = 8;
    private static final int MARGIN = 2;
    private static final double STIFFNESS = 0.15;
    private static final double DECAY = 0.1;
    private static final int SWEEPS = 12;

    /** Penetration tolerated before the organ deforms: the gap between flat faces and the round organ. */
    private static final double SLACK_MM = 1;

    private final double[] origin = new double[3];
    private final int[] count = new int[3];
    private final int[] stride = new int[3];
    private final TriangleTree surface;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final double[] normals;
    private final double[] distance;
    private final double[] requested;
    private final double[] weight;
    private final double[] inverseDiagonal;
    private double[] displacement;
    private double[] next;
    private final double[] fraction = new double[3];
    /** Interpolation weights of the eight grid nodes around a point. */
    private final double[] cornerWeights = new double[8];

    private double allowedDepth = SLACK_MM;
    /** Range of nodes with a requested displacement, per axis; empty where the last is before the first. */
    private final int[] first = new int[3];

    private final int[] last = new int[3];

    LiverIndentation(TriangleMesh organ) {
        this(new TriangleTree(organ), MeshMeasure.vertexNormals(organ));
    }

    /** The same organ, not indented, with working memory of its own. */
    LiverIndentation(LiverIndentation like) {
        this(like.surface, like.normals);
        allowedDepth = like.allowedDepth;
    }

    private LiverIndentation(TriangleTree surface, double[] normals) {
        this.surface = surface;
        this.normals = normals;
        double[] box = surface.mesh().bounds();
        int all = 1;
        for (int axis = 0; axis < 3; axis++) {
            origin[axis] = box[axis] - MARGIN * SPACING_MM;
            count[axis] = 1 + 2 * MARGIN + (int) Math.ceil((box[3 + axis] - box[axis]) / SPACING_MM);
            stride[axis] = all;
            all *= count[axis];
        }
        distance = new double[all];
        requested = new double[3 * all];
        weight = new double[all];
        inverseDiagonal = new double[3 * all];
        displacement = new double[3 * all];
        next = new double[3 * all];
        Arrays.fill(distance, Double.NaN);
        clearRange();
    }

    /** Signed distance of a grid node from the surface, negative inside; computed on first use. */
    private double distance(int node) {
        if (Double.isNaN(distance[node])) {
            int row = node / count[0];
            int layer = row / count[1];
            measure(
                    node,
                    origin[0] + SPACING_MM * (node % count[0]),
                    origin[1] + SPACING_MM * (row % count[1]),
                    origin[2] + SPACING_MM * layer);
        }
        return distance[node];
    }

    private void measure(int node, double x, double y, double z) {
        surface.closest(x, y, z, hit);
        int[] corners = surface.mesh().triangles();
        int a = 3 * corners[3 * hit.triangle];
        int b = 3 * corners[3 * hit.triangle + 1];
        int c = 3 * corners[3 * hit.triangle + 2];
        double out = (x - hit.x) * normal(a, b, c);
        out += (y - hit.y) * normal(a + 1, b + 1, c + 1);
        out += (z - hit.z) * normal(a + 2, b + 2, c + 2);
        distance[node] = Math.copySign(Math.sqrt(hit.distanceSquared), out);
    }

    private double normal(int a, int b, int c) {
        return hit.weightA * normals[a] + hit.weightB * normals[b] + hit.weightC * normals[c];
    }

    /** Tolerates the penetration that a point has at rest, whatever its depth. */
    void allowRestDepth(double x, double y, double z) {
        if (contains(x, y, z)) {
            allowedDepth = Math.max(allowedDepth, SLACK_MM - sample(at(x, y, z)));
        }
    }

    /** Clears the requested displacements. */
    void clear() {
        if (last[0] >= 0) {
            for (int k = firstReached(2, SWEEPS); k <= lastReached(2, SWEEPS); k++) {
                for (int j = firstReached(1, SWEEPS); j <= lastReached(1, SWEEPS); j++) {
                    int from = row(j, k) + firstReached(0, SWEEPS);
                    int end = row(j, k) + lastReached(0, SWEEPS) + 1;
                    Arrays.fill(weight, from, end, 0);
                    Arrays.fill(requested, 3 * from, 3 * end, 0);
                    Arrays.fill(displacement, 3 * from, 3 * end, 0);
                    Arrays.fill(next, 3 * from, 3 * end, 0);
                }
            }
        }
        clearRange();
    }

    private void clearRange() {
        Arrays.fill(first, Integer.MAX_VALUE);
        Arrays.fill(last, -1);
    }

    /**
     * First node along an axis that a number of sweeps can reach. Each sweep spreads the displacement by one node. The
     * outermost nodes lie outside the organ and stay fixed.
     */
    private int firstReached(int axis, int sweeps) {
        return Math.max(1, first[axis] - sweeps);
    }

    private int lastReached(int axis, int sweeps) {
        return Math.min(count[axis] - 2, last[axis] + sweeps);
    }

    private int row(int j, int k) {
        return j * stride[1] + k * stride[2];
    }

    /**
     * Requests that a penetrating point displaces the surface. The displacement starts at 0 at the tolerated depth and
     * rises continuously to the full depth.
     */
    void indent(double x, double y, double z) {
        if (!contains(x, y, z)) {
            return;
        }
        int node = at(x, y, z);
        double depth = -sample(node);
        if (depth <= allowedDepth) {
            return;
        }
        double gx = slope(node, 0);
        double gy = slope(node, 1);
        double gz = slope(node, 2);
        double length = Math.sqrt(gx * gx + gy * gy + gz * gz);
        if (length == 0) {
            return;
        }
        double in = -Math.min(2 * (depth - allowedDepth), depth) / length;
        double out = depth / length;
        if (contains(x + out * gx, y + out * gy, z + out * gz)) {
            addRequestedDisplacement(at(x + out * gx, y + out * gy, z + out * gz), in * gx, in * gy, in * gz);
        }
    }

    private void addRequestedDisplacement(int node, double x, double y, double z) {
        extendRange(0, node % count[0]);
        extendRange(1, node / stride[1] % count[1]);
        extendRange(2, node / stride[2]);
        for (int corner = 0; corner < 8; corner++) {
            double w = cornerWeights[corner];
            int i = corner(node, corner);
            weight[i] += w;
            requested[3 * i] += w * x;
            requested[3 * i + 1] += w * y;
            requested[3 * i + 2] += w * z;
        }
    }

    /** Extends the range of nodes with a requested displacement by a node and the next along an axis. */
    private void extendRange(int axis, int node) {
        first[axis] = Math.min(first[axis], node);
        last[axis] = Math.max(last[axis], node + 1);
    }

    /** Relaxes the displacements under all requests; returns whether the organ is indented anywhere. */
    boolean relax() {
        if (last[0] < 0) {
            return false;
        }
        for (int k = firstReached(2, SWEEPS); k <= lastReached(2, SWEEPS); k++) {
            for (int j = firstReached(1, SWEEPS); j <= lastReached(1, SWEEPS); j++) {
                normalizeRequests(row(j, k) + firstReached(0, SWEEPS), row(j, k) + lastReached(0, SWEEPS) + 1);
            }
        }
        for (int sweep = 1; sweep <= SWEEPS; sweep++) {
            for (int k = firstReached(2, sweep); k <= lastReached(2, sweep); k++) {
                for (int j = firstReached(1, sweep); j <= lastReached(1, sweep); j++) {
                    relaxRow(3 * (row(j, k) + firstReached(0, sweep)), 3 * (row(j, k) + lastReached(0, sweep) + 1));
                }
            }
            double[] swept = next;
            next = displacement;
            displacement = swept;
        }
        return true;
    }

    /** Turns the sums of requests at some nodes into means (the initial values) and limits their weights. */
    private void normalizeRequests(int from, int end) {
        for (int i = from; i < end; i++) {
            double held = Math.min(weight[i], 1);
            double mean = weight[i] > 0 ? held / weight[i] : 0;
            double part = 1 / (held + STIFFNESS * (1 + DECAY));
            weight[i] = held;
            for (int axis = 3 * i; axis < 3 * i + 3; axis++) {
                requested[axis] *= mean;
                displacement[axis] = requested[axis];
                inverseDiagonal[axis] = part;
            }
        }
    }

    /** Relaxes part of a row of nodes, for the three axes in turn. */
    private void relaxRow(int from, int to) {
        int rows = 3 * stride[1];
        int layers = 3 * stride[2];
        double[] now = displacement;
        double[] out = next;
        double[] ask = requested;
        double[] part = inverseDiagonal;
        for (int i = from; i < to; i++) {
            double about = now[i - 3] + now[i + 3] + now[i - rows] + now[i + rows] + now[i - layers] + now[i + layers];
            out[i] = part[i] * (ask[i] + STIFFNESS / 6 * about);
        }
    }

    /** Whether a point is farther than a distance, in mm, from everything that can be displaced. */
    boolean isBeyond(double x, double y, double z, double mm) {
        return isBeyond(0, x, mm) || isBeyond(1, y, mm) || isBeyond(2, z, mm);
    }

    private boolean isBeyond(int axis, double value, double mm) {
        return value + mm < origin[axis] || value - mm > origin[axis] + SPACING_MM * (count[axis] - 1);
    }

    /** Displacement of the organ at a point, mm. */
    void at(double x, double y, double z, double[] out) {
        Arrays.fill(out, 0);
        if (isReached(0, x) && isReached(1, y) && isReached(2, z)) {
            int node = at(x, y, z);
            for (int corner = 0; corner < 8; corner++) {
                double w = cornerWeights[corner];
                int i = 3 * corner(node, corner);
                out[0] += w * displacement[i];
                out[1] += w * displacement[i + 1];
                out[2] += w * displacement[i + 2];
            }
        }
    }

    /** Whether a coordinate is within the reach of the requests along an axis. */
    private boolean isReached(int axis, double value) {
        double steps = (value - origin[axis]) / SPACING_MM;
        return steps > firstReached(axis, SWEEPS) - 1 && steps < lastReached(axis, SWEEPS) + 1;
    }

    private boolean contains(double x, double y, double z) {
        return isWithin(0, x) && isWithin(1, y) && isWithin(2, z);
    }

    private boolean isWithin(int axis, double value) {
        double steps = (value - origin[axis]) / SPACING_MM;
        return steps >= 0 && steps < count[axis] - 1;
    }

    /** Lower grid node of the cell that contains a point; stores the fractions within the cell. */
    private int at(double x, double y, double z) {
        int node = cellIndex(0, x) + cellIndex(1, y) * stride[1] + cellIndex(2, z) * stride[2];
        updateWeights();
        return node;
    }

    private int cellIndex(int axis, double value) {
        double steps = (value - origin[axis]) / SPACING_MM;
        int whole = (int) steps;
        fraction[axis] = steps - whole;
        return whole;
    }

    private int corner(int node, int corner) {
        return node + (corner & 1) + (corner >> 1 & 1) * stride[1] + (corner >> 2) * stride[2];
    }

    /** Updates {@link #cornerWeights} from the stored fractions. */
    private void updateWeights() {
        double x = fraction[0];
        double y = fraction[1];
        double z = fraction[2];
        cornerWeights[0] = (1 - x) * (1 - y) * (1 - z);
        cornerWeights[1] = x * (1 - y) * (1 - z);
        cornerWeights[2] = (1 - x) * y * (1 - z);
        cornerWeights[3] = x * y * (1 - z);
        cornerWeights[4] = (1 - x) * (1 - y) * z;
        cornerWeights[5] = x * (1 - y) * z;
        cornerWeights[6] = (1 - x) * y * z;
        cornerWeights[7] = x * y * z;
    }

    private double sample(int node) {
        double sum = 0;
        for (int corner = 0; corner < 8; corner++) {
            sum += cornerWeights[corner] * distance(corner(node, corner));
        }
        return sum;
    }

    /** Difference of the distance along an axis, mm per grid spacing. */
    private double slope(int node, int axis) {
        double kept = fraction[axis];
        fraction[axis] = 1;
        updateWeights();
        double high = sample(node);
        fraction[axis] = 0;
        updateWeights();
        double low = sample(node);
        fraction[axis] = kept;
        updateWeights();
        return high - low;
    }
}
