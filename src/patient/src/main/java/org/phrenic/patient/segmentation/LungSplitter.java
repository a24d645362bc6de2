package org.phrenic.patient.segmentation;

import java.util.Optional;
import org.phrenic.patient.label.LabelTable;

/**
 * Splits a label that two lungs share. Where the lungs have labels as well, it holds vessels or the like, which go to
 * the lung about them. Where one of them has, its largest component is the other lung if it is large enough, and
 * vessels of the one otherwise. Else the label is eroded until it separates into two large components. These are then
 * grown back, with each voxel assigned to the nearer one. The component closer to the patient's right is the right
 * lung.
 */
public final class LungSplitter {
    /**
     * Minimum size of the smaller lung relative to the larger one. A left lung usually has 0.85 of the right lung's
     * volume.
     */
    private static final double MIN_SHARE = 0.3;

    private static final int MAX_EROSIONS = 60;
    private static final String RIGHT = "lung_R";
    private static final String LEFT = "lung_L";

    private LungSplitter() {}

    /** Replaces the common segment by one per lung. Returns a note if the lungs cannot be split. */
    public static Optional<String> split(Segmentation segmentation) {
        int both = segmentation.find(LabelTable.LUNGS);
        if (segmentation.find(RIGHT) > 0 || segmentation.find(LEFT) > 0) {
            if (segmentation.find(RIGHT) == 0 || segmentation.find(LEFT) == 0) {
                nameOther(segmentation, new VoxelRegion(segmentation, both));
            }
            if (segmentation.counts()[both] > 0) {
                join(segmentation, new VoxelRegion(segmentation, both));
            }
            return Optional.empty();
        }
        VoxelRegion region = new VoxelRegion(segmentation, both);
        region.computeDepths();
        byte[] piece = new byte[region.cells()];
        for (int erosion = 0; erosion < MAX_EROSIONS; erosion++) {
            int[] sizes = region.connectedComponents(erosion, piece);
            int first = largest(sizes, 0);
            int second = largest(sizes, first);
            if (second > 0 && sizes[second] > MIN_SHARE * sizes[first]) {
                divide(segmentation, region, piece, first, second);
                return Optional.empty();
            }
            if (first == 0) {
                break;
            }
        }
        return Optional.of(LabelTable.LUNGS
                + ": found one body that does not part into two, expected both lungs"
                + " (or label one as lung_R or lung_L)");
    }

    /** Names the largest component the lung that has no label, unless it is too small beside the one that has. */
    private static void nameOther(Segmentation s, VoxelRegion region) {
        int labelled = s.counts()[Math.max(s.find(RIGHT), s.find(LEFT))];
        String other = s.find(RIGHT) > 0 ? LEFT : RIGHT;
        byte[] piece = new byte[region.cells()];
        int[] sizes = region.connectedComponents(0, piece);
        int first = largest(sizes, 0);
        if (sizes[first] > MIN_SHARE * labelled) {
            region.assign(piece, first, s.segment(other));
            s.inheritFrom(other, LabelTable.LUNGS);
        }
    }

    /**
     * Gives the voxels of the common segment to the lungs that have segments of their own, each to the lung from which
     * fewer steps through the common segment lead to it. Voxels that no lung leads to are discarded.
     */
    private static void join(Segmentation s, VoxelRegion region) {
        byte[] lungs = {(byte) s.find(RIGHT), (byte) s.find(LEFT)};
        byte[] piece = new byte[region.cells()];
        int[] steps = s.steps();
        for (int cell = 0; cell < piece.length; cell++) {
            for (int step = 0; step < 6 && region.isMember(cell) && piece[cell] == 0; step++) {
                int v = region.voxel(cell);
                byte next = s.isAtBorder(v, step) ? 0 : s.voxels[v + steps[step]];
                piece[cell] = (byte) (next == 0 ? 0 : next == lungs[0] ? 1 : next == lungs[1] ? 2 : 0);
            }
        }
        region.growRegions(piece);
        for (int cell = 0; cell < piece.length; cell++) {
            if (region.isMember(cell)) {
                s.voxels[region.voxel(cell)] = piece[cell] == 0 ? 0 : lungs[piece[cell] - 1];
            }
        }
    }

    private static int largest(int[] sizes, int but) {
        int largest = 0;
        for (int p = 1; p < sizes.length; p++) {
            if (p != but && sizes[p] > sizes[largest]) {
                largest = p;
            }
        }
        return largest;
    }

    private static void divide(Segmentation segmentation, VoxelRegion region, byte[] piece, int first, int second) {
        double[] x = new double[2];
        double[] count = new double[2];
        for (int cell = 0; cell < piece.length; cell++) {
            int which = piece[cell] == first ? 0 : piece[cell] == second ? 1 : -1;
            if (which >= 0) {
                x[which] += segmentation.coordinate(region.voxel(cell), 0);
                count[which]++;
            } else {
                piece[cell] = 0;
            }
        }
        region.growRegions(piece);
        // The x axis points to the patient's left.
        boolean firstIsRight = x[0] / count[0] < x[1] / count[1];
        byte right = (byte) segmentation.segment(RIGHT);
        byte left = (byte) segmentation.segment(LEFT);
        for (int cell = 0; cell < piece.length; cell++) {
            if (region.isMember(cell)) {
                boolean isFirst = piece[cell] == first;
                // Voxels connected to neither lung are discarded.
                segmentation.voxels[region.voxel(cell)] = piece[cell] == 0 ? 0 : isFirst == firstIsRight ? right : left;
            }
        }
        segmentation.inheritFrom(RIGHT, LabelTable.LUNGS);
        segmentation.inheritFrom(LEFT, LabelTable.LUNGS);
    }
}
