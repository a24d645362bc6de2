package org.phrenic.patient.segmentation;

import java.util.Optional;

/**
 * Tells two lungs under one label apart. Where they touch, the label is worn away from its surface, step by step, until
 * two large pieces are left; these grow back together, each voxel going to the nearer one. The piece farther to the
 * patient's right is the right lung.
 */
public final class LungSplitter {
    /** The smaller lung has at least this share of the larger: a left lung has 0.85 of a right one. */
    private static final double LEAST_SHARE = 0.3;

    private static final int MOST_STEPS = 60;

    private LungSplitter() {}

    /** Replaces the part of both lungs by one each; a sentence if they cannot be told apart. */
    public static Optional<String> split(Segmentation parts) {
        int both = parts.find(LabelTable.LUNGS);
        VoxelRegion flood = new VoxelRegion(parts, both);
        flood.computeDepths();
        byte[] piece = new byte[flood.cells()];
        for (int worn = 0; worn < MOST_STEPS; worn++) {
            int[] sizes = flood.connectedComponents(worn, piece);
            int first = largest(sizes, 0);
            int second = largest(sizes, first);
            if (second > 0 && sizes[second] > LEAST_SHARE * sizes[first]) {
                divide(parts, flood, piece, first, second);
                return Optional.empty();
            }
            if (first == 0) {
                break;
            }
        }
        return Optional.of(
                LabelTable.LUNGS
                        + ": found one body that does not part into two, expected both lungs (or label one as lung_R or lung_L)");
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

    private static void divide(Segmentation parts, VoxelRegion flood, byte[] piece, int first, int second) {
        double[] x = new double[2];
        double[] count = new double[2];
        for (int cell = 0; cell < piece.length; cell++) {
            int which = piece[cell] == first ? 0 : piece[cell] == second ? 1 : -1;
            if (which >= 0) {
                x[which] += parts.coordinate(flood.voxel(cell), 0);
                count[which]++;
            } else {
                piece[cell] = 0;
            }
        }
        flood.growRegions(piece);
        // x runs to the patient's left.
        boolean firstIsRight = x[0] / count[0] < x[1] / count[1];
        byte right = (byte) parts.segment("lung_R");
        byte left = (byte) parts.segment("lung_L");
        for (int cell = 0; cell < piece.length; cell++) {
            if (flood.isMember(cell)) {
                boolean isFirst = piece[cell] == first;
                // Specks that no path joins to a lung are left out.
                parts.voxels[flood.voxel(cell)] = piece[cell] == 0 ? 0 : isFirst == firstIsRight ? right : left;
            }
        }
        parts.inheritFrom("lung_R", LabelTable.LUNGS);
        parts.inheritFrom("lung_L", LabelTable.LUNGS);
    }
}
