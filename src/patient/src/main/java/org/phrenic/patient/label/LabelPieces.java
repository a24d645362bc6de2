package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;

/** Counts the connected pieces of labels, to tell the ribs of a side from one rib. */
final class LabelPieces {
    /** Least number of pieces of several ribs; one that is broken or cut off by the scan has fewer. */
    private static final int SEVERAL = 4;
    /** Least voxels of a piece over those of the largest one; smaller pieces are specks. */
    private static final double LEAST_SHARE = 0.1;

    private final LabelGrid grid;
    private final BitSet left = new BitSet();

    private LabelPieces(LabelGrid grid, Set<Integer> labels) {
        this.grid = grid;
        for (int voxel = 0; voxel < grid.voxelCount(); voxel++) {
            if (labels.contains(grid.label(voxel))) {
                left.set(voxel);
            }
        }
    }

    /** Whether the voxels of some labels together are so many pieces that they are several ribs. */
    static boolean areSeveral(LabelGrid grid, List<Integer> labels) {
        LabelPieces pieces = new LabelPieces(grid, new HashSet<>(labels));
        List<Integer> sizes = new ArrayList<>();
        for (int first = pieces.left.nextSetBit(0); first >= 0; first = pieces.left.nextSetBit(first + 1)) {
            sizes.add(pieces.take(first));
        }
        int largest = sizes.isEmpty() ? 0 : Collections.max(sizes);
        return sizes.stream().filter(size -> size >= LEAST_SHARE * largest).count() >= SEVERAL;
    }

    /** Takes away the piece of a voxel, whose voxels touch by a corner at least; returns their number. */
    private int take(int first) {
        IntList piece = new IntList();
        left.clear(first);
        piece.add(first);
        for (int n = 0; n < piece.size(); n++) {
            int voxel = piece.get(n);
            int i = voxel % grid.columns();
            int j = voxel / grid.columns() % grid.rows();
            int k = voxel / grid.columns() / grid.rows();
            for (int z = Math.max(0, k - 1); z <= Math.min(grid.slices() - 1, k + 1); z++) {
                for (int y = Math.max(0, j - 1); y <= Math.min(grid.rows() - 1, j + 1); y++) {
                    for (int x = Math.max(0, i - 1); x <= Math.min(grid.columns() - 1, i + 1); x++) {
                        int next = x + grid.columns() * (y + grid.rows() * z);
                        if (left.get(next)) {
                            left.clear(next);
                            piece.add(next);
                        }
                    }
                }
            }
        }
        return piece.size();
    }
}
