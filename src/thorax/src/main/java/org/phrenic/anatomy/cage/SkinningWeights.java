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
 * Skinning weights of points: the bodies that move a point and their weights. The weights of a point are a mean over
 * the nearby {@link BoneSamples} with smooth radial fall-off, so that points along the costal margin move smoothly.
 */
public final class SkinningWeights {
    /** Maximum number of bodies per point. */
    public static final int MAX_BODIES = 4;

    /** Support radius beyond the distance of the nearest sample, mm: half the width of an intercostal space. */
    private static final double SUPPORT_MM = 14;
    /** Points within a cube of this size, mm, are searched together. */
    private static final double BATCH_CELL_MM = 25;

    /**
     * Weights of a set of points.
     *
     * @param body body indices, {@link #MAX_BODIES} per point
     * @param weight weight of each entry; 0 if unused
     * @param distance distance of each point from the nearest bone, mm
     */
    public record Weights(int[] body, double[] weight, double[] distance) {}

    /** Cell size of the search grid, mm: a few samples per cell. */
    private static final double CELL_MM = 20;

    private static final int SEVERAL_BODIES = -1;

    private final int bodies;
    /** Coordinates x, y, z of the samples, sorted by cell. */
    private double[] sample;

    private double[][] sampleWeights;
    /** Body of each sample; {@link #SEVERAL_BODIES} for a sample of cartilage. */
    private int[] sampleBody;
    /** First sample of each non-empty cell; {@code cellBox} bounds its samples (low x, y, z, high x, y, z). */
    private int[] cellStart;

    private double[] cellBox;

    private SkinningWeights(int bodies, BoneSamples samples) {
        this.bodies = bodies;
        sortIntoCells(samples.points, samples.weights);
    }

    /** Builds the weights from samples of the bones of a thorax. */
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

    /** Computes the weights of points (mm) in parallel; the result does not depend on the number of threads. */
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

    /** Distance of points from the nearest bone, mm, as in {@link #weightsAt}, without computing weights. */
    public double[] distances(double[] where) {
        double[] out = new double[where.length / 3];
        forEachBatch(where, (points, search) -> {
            for (int i : points) {
                out[i] = search.nearest(where[3 * i], where[3 * i + 1], where[3 * i + 2]);
            }
        });
        return out;
    }

    /** Runs a task in parallel on batches of nearby points. Each batch shares one search, which visits few cells. */
    private void forEachBatch(double[] where, BiConsumer<int[], Search> task) {
        int n = where.length / 3;
        long[] order = new long[n];
        for (int i = 0; i < n; i++) {
            // Key collisions of distant points make their search slower but remain exact.
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

    /** Key of the cube that contains a point: ten low bits of each coordinate's index, 30 bits in all. */
    private static long key(double[] p, int at, double size) {
        long key = 0;
        for (int axis = 0; axis < 3; axis++) {
            key = (key << 10) | ((long) Math.floor(p[at + axis] / size) & 0x3ff);
        }
        return key;
    }

    /** Candidate cells for a batch of points, with the squared distance of each to the point searched last. */
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

        /** Distance to the nearest sample. */
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

    /** Largest squared distance between a box and the box of a cell. */
    private double maxSquaredDistance(int cell, double[] box) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double most = Math.max(box[3 + axis] - cellBox[6 * cell + axis], cellBox[6 * cell + 3 + axis] - box[axis]);
            sum += most * most;
        }
        return sum;
    }

    /** Smallest squared distance between a box and the box of a cell. */
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

    /** Squared distance of a point to the box of a cell's samples. */
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
