package org.phrenic.anatomy.cage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.force.FallOff;
import org.phrenic.engine.math.ArgSort;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.mesh.BoundingBoxes;

/**
 * Skinning weights: the bones that move a point, and their shares. A point takes the mean of the {@link BoneSamples}
 * around it, which fades smoothly with distance, so that a row of points along the costal margin moves as one smooth
 * band.
 */
public final class SkinningWeights {
    /** Bodies that may carry one point. */
    public static final int MAX_BODIES = 4;

    /**
     * How much farther than the nearest sample a sample may be and still count, mm: half the space between two ribs.
     */
    private static final double SUPPORT_MM = 14;
    /** Points within a cube of this size are searched for together. */
    private static final double BATCH_CELL_MM = 25;

    /**
     * What carries some points.
     *
     * @param body {@link #MAX_BODIES} entries a point
     * @param weight of each entry, 0 for one not used
     * @param distance of each point from the nearest bone, mm
     */
    public record Weights(int[] body, double[] weight, double[] distance) {}

    /** Samples are searched by cells of this size: a few samples each. */
    private static final double CELL_MM = 20;

    private static final int SEVERAL_BODIES = -1;

    private final int bodies;
    /** Samples sorted by cell, x, y, z each, and what moves each. */
    private double[] sample;

    private double[][] sampleWeights;
    /** The one body that carries a sample; {@link #SEVERAL_BODIES} for a sample of cartilage. */
    private int[] sampleBody;
    /** First sample of each cell that holds any, and the box of its samples: low x, y, z, high x, y, z. */
    private int[] cellStart;

    private double[] cellBox;

    private SkinningWeights(int bodies, BoneSamples samples) {
        this.bodies = bodies;
        sortIntoCells(samples.points, samples.weights);
    }

    /** Samples of the bones of a thorax. */
    public static SkinningWeights of(Thorax thorax, RibCage cage) {
        return new SkinningWeights(cage.bodies().size(), BoneSamples.of(thorax, cage));
    }

    private void sortIntoCells(List<double[]> points, List<double[]> weights) {
        int count = points.size();
        long[] key = new long[count];
        for (int j = 0; j < count; j++) {
            key[j] = key(points.get(j), 0, CELL_MM);
        }
        int[] order = ArgSort.of(key);
        sample = new double[3 * count];
        sampleWeights = new double[count][];
        sampleBody = new int[count];
        int[] start = new int[count + 1];
        double[] box = new double[6 * count];
        int cells = 0;
        for (int at = 0; at < count; at++) {
            int j = order[at];
            double[] point = points.get(j);
            if (at == 0 || key[j] != key[order[at - 1]]) {
                start[cells] = at;
                BoundingBoxes.setEmpty(box, 6 * cells);
                cells++;
            }
            sampleWeights[at] = weights.get(j);
            sampleBody[at] = soleBody(weights.get(j));
            System.arraycopy(point, 0, sample, 3 * at, 3);
            BoundingBoxes.include(box, 6 * (cells - 1), point, 0);
        }
        start[cells] = count;
        cellStart = Arrays.copyOf(start, cells + 1);
        cellBox = Arrays.copyOf(box, 6 * cells);
    }

    private static int soleBody(double[] weight) {
        for (int b = 0; b < weight.length; b++) {
            if (weight[b] == 1) {
                return b;
            }
        }
        return SEVERAL_BODIES;
    }

    /** Weights of points, mm; shared out among the cores by runs of points, each of which is found by itself. */
    public Weights weightsAt(double[] where) {
        int n = where.length / 3;
        Weights blend = new Weights(new int[n * MAX_BODIES], new double[n * MAX_BODIES], new double[n]);
        forEachBatch(where, (points, search) -> {
            double[] sum = new double[bodies];
            for (int i : points) {
                computeWeights(where, i, search, sum, blend);
            }
        });
        return blend;
    }

    /** Distance of points from the nearest bone, mm: what {@link #weightsAt} gives too, without the weights. */
    public double[] distances(double[] where) {
        double[] out = new double[where.length / 3];
        forEachBatch(where, (points, search) -> {
            for (int i : points) {
                out[i] = search.nearest(where[3 * i], where[3 * i + 1], where[3 * i + 2]);
            }
        });
        return out;
    }

    /** Gives points that lie together to one search, which then looks at few cells; on all cores. */
    private void forEachBatch(double[] where, BiConsumer<int[], Search> task) {
        int n = where.length / 3;
        long[] order = new long[n];
        for (int i = 0; i < n; i++) {
            // Two points far apart may share a cube's number, which makes their search slower and no less exact.
            order[i] = key(where, 3 * i, BATCH_CELL_MM) << 32 | i;
        }
        RadixSort.sort(order);
        List<int[]> runs = new ArrayList<>();
        int from = 0;
        for (int k = 1; k <= n; k++) {
            if (k == n || order[k] >>> 32 != order[from] >>> 32) {
                int[] run = new int[k - from];
                for (int i = from; i < k; i++) {
                    run[i - from] = (int) order[i];
                }
                runs.add(run);
                from = k;
            }
        }
        runs.parallelStream().forEach(run -> task.accept(run, new Search(where, run)));
    }

    /** Number of the cube of this size that holds a point; each axis takes ten of its low 30 bits. */
    private static long key(double[] p, int at, double size) {
        long key = 0;
        for (int axis = 0; axis < 3; axis++) {
            key = (key << 10) | ((long) Math.floor(p[at + axis] / size) & 0x3ff);
        }
        return key;
    }

    /**
     * The cells that can matter to any of some points, with the squared distance of each from the point looked at last.
     */
    private final class Search {
        private final int[] cells;
        private final double[] toCell;

        Search(double[] where, int[] points) {
            double[] box = new double[6];
            BoundingBoxes.setEmpty(box, 0);
            for (int i : points) {
                BoundingBoxes.include(box, 0, where, 3 * i);
            }
            int all = cellStart.length - 1;
            double farthest = Double.POSITIVE_INFINITY;
            for (int c = 0; c < all; c++) {
                farthest = Math.min(farthest, maxSquaredDistance(c, box));
            }
            double limit = Math.sqrt(farthest) + SUPPORT_MM;
            int[] near = new int[all];
            int count = 0;
            for (int c = 0; c < all; c++) {
                if (!(minSquaredDistance(c, box) > limit * limit)) {
                    near[count++] = c;
                }
            }
            cells = Arrays.copyOf(near, count);
            toCell = new double[count];
        }

        /** Distance from the nearest sample. */
        double nearest(double x, double y, double z) {
            int first = 0;
            for (int k = 0; k < cells.length; k++) {
                toCell[k] = squaredDistanceToBox(cells[k], x, y, z);
                first = toCell[k] < toCell[first] ? k : first;
            }
            double nearest = nearestIn(cells[first], x, y, z, Double.POSITIVE_INFINITY);
            for (int k = 0; k < cells.length; k++) {
                if (toCell[k] < nearest) {
                    nearest = nearestIn(cells[k], x, y, z, nearest);
                }
            }
            return Math.sqrt(nearest);
        }
    }

    /** Greatest squared distance of a point of a box from one of a cell's box. */
    private double maxSquaredDistance(int cell, double[] box) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double most = Math.max(box[3 + axis] - cellBox[6 * cell + axis], cellBox[6 * cell + 3 + axis] - box[axis]);
            sum += most * most;
        }
        return sum;
    }

    /** Least squared distance of a point of a box from one of a cell's box. */
    private double minSquaredDistance(int cell, double[] box) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double gap = Math.max(
                    0, Math.max(cellBox[6 * cell + axis] - box[3 + axis], box[axis] - cellBox[6 * cell + 3 + axis]));
            sum += gap * gap;
        }
        return sum;
    }

    private void computeWeights(double[] where, int i, Search search, double[] sum, Weights blend) {
        double x = where[3 * i];
        double y = where[3 * i + 1];
        double z = where[3 * i + 2];
        double distance = search.nearest(x, y, z);
        blend.distance[i] = distance;
        double reach = distance + SUPPORT_MM;
        Arrays.fill(sum, 0);
        for (int k = 0; k < search.cells.length; k++) {
            if (search.toCell[k] < reach * reach) {
                accumulateCell(search.cells[k], x, y, z, reach, sum);
            }
        }
        keepLargestWeights(sum, blend.body, blend.weight, i * MAX_BODIES);
    }

    /** Squared distance from the box of a cell's samples. */
    private double squaredDistanceToBox(int cell, double x, double y, double z) {
        return BoundingBoxes.squaredDistance(cellBox, 6 * cell, x, y, z);
    }

    private double nearestIn(int cell, double x, double y, double z, double known) {
        double nearest = known;
        for (int j = cellStart[cell]; j < cellStart[cell + 1]; j++) {
            double square = squared(j, x, y, z);
            nearest = square < nearest ? square : nearest;
        }
        return nearest;
    }

    private void accumulateCell(int cell, double x, double y, double z, double reach, double[] sum) {
        for (int j = cellStart[cell]; j < cellStart[cell + 1]; j++) {
            double squared = squared(j, x, y, z);
            if (squared < reach * reach) {
                double f = FallOff.at(Math.sqrt(squared), reach);
                if (sampleBody[j] != SEVERAL_BODIES) {
                    sum[sampleBody[j]] += f;
                    continue;
                }
                double[] w = sampleWeights[j];
                for (int b = 0; b < w.length; b++) {
                    sum[b] += f * w[b];
                }
            }
        }
    }

    private double squared(int j, double x, double y, double z) {
        double dx = sample[3 * j] - x;
        double dy = sample[3 * j + 1] - y;
        double dz = sample[3 * j + 2] - z;
        return dx * dx + dy * dy + dz * dz;
    }

    private static void keepLargestWeights(double[] sum, int[] body, double[] weight, int at) {
        double total = 0;
        for (int k = 0; k < MAX_BODIES; k++) {
            int best = 0;
            for (int b = 1; b < sum.length; b++) {
                if (sum[b] > sum[best]) {
                    best = b;
                }
            }
            body[at + k] = best;
            weight[at + k] = Math.max(0, sum[best]);
            total += weight[at + k];
            sum[best] = Double.NEGATIVE_INFINITY;
        }
        for (int k = 0; k < MAX_BODIES; k++) {
            weight[at + k] = total > 0 ? weight[at + k] / total : k == 0 ? 1 : 0;
        }
    }
}
