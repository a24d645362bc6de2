package org.phrenic.patient.numbering;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.patient.segmentation.Segmentation;

/**
 * The axis of the spine in a segment that holds all bones: in layers of some millimetres the middle of the bone behind
 * the lungs in the median plane, and the front of it. It is followed up and down from the middle of the lungs; layers
 * without bone there, such as discs, take the values of their neighbour.
 */
final class SpineAxis {
    private static final double LAYER_MM = 4;
    /** Half the width of the spine, mm: transverse processes reach farther and stay with the ribs. */
    private static final double HALF_WIDTH_MM = 30;
    /** Half the width in which the axis is looked for, mm. */
    private static final double SEARCH_MM = 22;
    /** Distance by which the front may move from one layer to the next, mm. */
    private static final double FRONT_MM = 10;
    /** Share of the bone that lies before the front. */
    private static final double FRONT_SHARE = 0.05;
    /** Share by which the axis follows a layer. */
    private static final double FOLLOW = 0.4;
    /** Least area of bone in a layer that is followed, mm^2. */
    private static final double LEAST_MM2 = 150;

    private final double lowest;
    private final double[] x;
    private final double[] front;

    private SpineAxis(double lowest, int layers) {
        this.lowest = lowest;
        x = new double[layers];
        front = new double[layers];
    }

    /**
     * Finds the axis.
     *
     * @param segment of all bones
     * @param right mean of the voxels of the right lung, mm
     * @param left mean of the voxels of the left lung, mm
     * @return empty if no bone lies behind the lungs in the median plane
     */
    static Optional<SpineAxis> of(Segmentation s, int segment, double[] right, double[] left) {
        int count = s.counts()[segment];
        double[] z = new double[count];
        double[] across = new double[count];
        double[] back = new double[count];
        int n = 0;
        for (int v = 0; v < s.voxels().length; v++) {
            if (s.segmentAt(v) == segment) {
                across[n] = s.coordinate(v, 0);
                back[n] = s.coordinate(v, 1);
                z[n++] = s.coordinate(v, 2);
            }
        }
        double low = Arrays.stream(z).min().orElse(0);
        double high = Arrays.stream(z).max().orElse(0);
        int layers = (int) ((high - low) / LAYER_MM) + 1;
        int[][] inLayer = new int[layers][];
        int[] sizes = new int[layers];
        for (double height : z) {
            sizes[(int) ((height - low) / LAYER_MM)]++;
        }
        Arrays.setAll(inLayer, layer -> new int[sizes[layer]]);
        int[] filled = new int[layers];
        for (int i = 0; i < n; i++) {
            int layer = (int) ((z[i] - low) / LAYER_MM);
            inLayer[layer][filled[layer]++] = i;
        }
        SpineAxis axis = new SpineAxis(low, layers);
        int start = Math.max(0, Math.min(layers - 1, (int) ((0.5 * (right[2] + left[2]) - low) / LAYER_MM)));
        double least = LEAST_MM2 * LAYER_MM / s.grid().voxelVolume();
        axis.x[start] = 0.5 * (right[0] + left[0]);
        axis.front[start] = 0.5 * (right[1] + left[1]) + FRONT_MM;
        boolean found = false;
        for (int round = 0; round < 3; round++) {
            found = axis.follow(start, start, inLayer[start], across, back, least, 1);
        }
        for (int layer = start + 1; layer < layers; layer++) {
            found |= axis.follow(layer, layer - 1, inLayer[layer], across, back, least, FOLLOW);
        }
        for (int layer = start - 1; layer >= 0; layer--) {
            found |= axis.follow(layer, layer + 1, inLayer[layer], across, back, least, FOLLOW);
        }
        return found ? Optional.of(axis) : Optional.empty();
    }

    /** Takes axis and front of a layer from its bone near those of another layer; returns whether there is some. */
    private boolean follow(
            int layer, int from, int[] voxels, double[] across, double[] back, double least, double share) {
        double[] fronts = new double[voxels.length];
        double sum = 0;
        int count = 0;
        for (int i : voxels) {
            if (Math.abs(across[i] - x[from]) < SEARCH_MM && back[i] > front[from] - FRONT_MM) {
                sum += across[i];
                fronts[count++] = back[i];
            }
        }
        if (count == 0 || count < least) {
            x[layer] = x[from];
            front[layer] = front[from];
            return false;
        }
        Arrays.sort(fronts, 0, count);
        double foremost = fronts[(int) (FRONT_SHARE * count)];
        x[layer] = x[from] + share * (sum / count - x[from]);
        front[layer] = front[from] + share * (foremost - front[from]);
        return true;
    }

    private int layer(double z) {
        return Math.max(0, Math.min(x.length - 1, (int) ((z - lowest) / LAYER_MM)));
    }

    /** The axis at a height, mm. */
    double x(double z) {
        return x[layer(z)];
    }

    /** Distance from the axis to the side, mm. */
    double beside(double[] p) {
        return Math.abs(p[0] - x(p[2]));
    }

    boolean isRight(double[] p) {
        // The x axis points to the patient's left.
        return p[0] < x(p[2]);
    }

    /** Whether a point lies as far back as the spine. */
    boolean isBehindFront(double[] p) {
        return p[1] > front[layer(p[2])] - FRONT_MM;
    }

    /** Whether a voxel belongs to the spine. */
    boolean contains(Segmentation s, int voxel) {
        double[] p = s.point(voxel);
        return beside(p) <= HALF_WIDTH_MM && isBehindFront(p);
    }
}
