package org.phrenic.patient.segmentation;

import java.util.Arrays;

/** Where a component of lungs under one label lies, mm, and how large it is. */
final class LungPlace {
    /** Lower share of a lung's height, beside which gas in the stomach and the bowel lies. */
    private static final double LOW_SHARE = 0.25;

    final int mark;
    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private final double[] sum = new double[3];
    private int voxels;
    private int grown;

    private LungPlace(int mark) {
        this.mark = mark;
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
    }

    static LungPlace of(Segmentation s, VoxelRegion region, byte[] piece, int mark) {
        LungPlace place = new LungPlace(mark);
        for (int cell = 0; cell < piece.length; cell++) {
            if (piece[cell] == mark) {
                place.add(s, region.voxel(cell));
            }
        }
        return place;
    }

    /** The largest component of a segment. */
    static LungPlace ofLargest(Segmentation s, VoxelRegion region) {
        byte[] piece = new byte[region.cells()];
        return of(s, region, piece, LungSplitter.largest(region.connectedComponents(0, piece), 0));
    }

    private void add(Segmentation s, int voxel) {
        voxels++;
        grown++;
        for (int axis = 0; axis < 3; axis++) {
            double at = s.coordinate(voxel, axis);
            low[axis] = Math.min(low[axis], at);
            high[axis] = Math.max(high[axis], at);
            sum[axis] += at;
        }
    }

    int voxels() {
        return voxels;
    }

    /** Number of its voxels once it is {@link #growBack grown back}; of all its voxels without. */
    int grown() {
        return grown;
    }

    /**
     * Counts the voxels that two components have once they are grown back.
     *
     * @param piece components, which become theirs
     */
    static void growBack(VoxelRegion region, byte[] piece, LungPlace a, LungPlace b) {
        for (int cell = 0; cell < piece.length; cell++) {
            piece[cell] = piece[cell] == a.mark || piece[cell] == b.mark ? piece[cell] : 0;
        }
        region.growRegions(piece);
        a.grown = 0;
        b.grown = 0;
        for (byte of : piece) {
            a.grown += of == a.mark ? 1 : 0;
            b.grown += of == b.mark ? 1 : 0;
        }
    }

    double size(int axis) {
        return high[axis] - low[axis];
    }

    double centre(int axis) {
        return sum[axis] / voxels;
    }

    /** Whether neither component reaches from right to left about the middle of the other. */
    boolean isBeside(LungPlace other) {
        return !spans(other.centre(0)) && !other.spans(centre(0));
    }

    /** Whether this is a lobe of one of two lungs: beside the other, and nearer to the one than that is. */
    boolean isPartOf(LungPlace lung, LungPlace other) {
        return isBeside(other) && Math.abs(centre(0) - lung.centre(0)) < Math.abs(other.centre(0) - lung.centre(0));
    }

    boolean spans(double x) {
        return x >= low[0] && x <= high[0];
    }

    /** Whether the middle lies as high as the other component, and not at its lower end. */
    boolean isAtHeightOf(LungPlace other) {
        return centre(2) >= other.low[2] + LOW_SHARE * other.size(2) && centre(2) <= other.high[2];
    }
}
