package org.phrenic.patient.segmentation;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Connected components of groups of segments. Voxels are stored as runs: sequences along a row that belong to one
 * segment. Runs of the same group that touch are one component.
 */
public final class VoxelRuns {
    private static final int START = 1 << 14;

    private final Segmentation segmentation;
    private final byte[] groupOfSegment;
    /** First voxel of each run and the voxel after its last, as indices into the volume. */
    private int[] from = new int[START];

    private int[] to = new int[START];
    private int count;
    /** First run of each row. */
    private final int[] firstOfRow;

    private final int[] parent;
    private final int[] sizes;

    /**
     * Finds the components of a volume.
     *
     * @param groupOfSegment group of each segment number; voxels of group 0 are left out
     * @param corners whether voxels that share only an edge or a corner touch (26 neighbours instead of 6)
     */
    public VoxelRuns(Segmentation segmentation, byte[] groupOfSegment, boolean corners) {
        this.segmentation = segmentation;
        this.groupOfSegment = groupOfSegment;
        firstOfRow = new int[segmentation.rows * segmentation.slices + 1];
        findRuns();
        parent = DisjointSets.singletons(count);
        for (int k = 0; k < segmentation.slices; k++) {
            for (int j = 0; j < segmentation.rows; j++) {
                uniteWithinRow(j + segmentation.rows * k);
                unite(j, k, j - 1, k, corners ? 1 : 0);
                unite(j, k, j, k - 1, corners ? 1 : 0);
                if (corners) {
                    unite(j, k, j - 1, k - 1, 1);
                    unite(j, k, j + 1, k - 1, 1);
                }
            }
        }
        sizes = new int[count];
        for (int run = 0; run < count; run++) {
            sizes[component(run)] += to[run] - from[run];
        }
    }

    /** Voxels of each component, by its number, in the order of the volume. */
    public Map<Integer, IntList> voxels(IntPredicate wantedRun) {
        Map<Integer, IntList> voxels = new TreeMap<>();
        for (int run = 0; run < count; run++) {
            if (wantedRun.test(run)) {
                IntList list = voxels.computeIfAbsent(component(run), component -> new IntList());
                for (int v = from[run]; v < to[run]; v++) {
                    list.add(v);
                }
            }
        }
        return voxels;
    }

    /** The components of each segment by itself. */
    static VoxelRuns ofSegments(Segmentation segmentation) {
        byte[] groups = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        for (int segment = 1; segment < groups.length; segment++) {
            groups[segment] = (byte) segment;
        }
        return new VoxelRuns(segmentation, groups, false);
    }

    private void findRuns() {
        byte[] voxels = segmentation.voxels;
        int columns = segmentation.columns;
        for (int row = 0; row < firstOfRow.length - 1; row++) {
            firstOfRow[row] = count;
            int end = (row + 1) * columns;
            int at = row * columns;
            while (at < end) {
                byte segment = voxels[at];
                int first = at++;
                while (at < end && voxels[at] == segment) {
                    at++;
                }
                if (groupOfSegment[segment & LabelGrid.MAX_BYTE_LABEL] != 0) {
                    if (count == from.length) {
                        from = Arrays.copyOf(from, 2 * count);
                        to = Arrays.copyOf(to, 2 * count);
                    }
                    from[count] = first;
                    to[count++] = at;
                }
            }
        }
        firstOfRow[firstOfRow.length - 1] = count;
    }

    private byte group(int run) {
        return groupOfSegment[segmentation.segmentAt(from[run])];
    }

    /** Joins neighbouring runs of a row, which are of different segments. */
    private void uniteWithinRow(int row) {
        for (int run = firstOfRow[row] + 1; run < firstOfRow[row + 1]; run++) {
            if (from[run] == to[run - 1] && group(run) == group(run - 1)) {
                DisjointSets.unionToLower(parent, run, run - 1);
            }
        }
    }

    /** Joins the runs of a row to those of an earlier one that touch them. */
    private void unite(int j, int k, int otherJ, int otherK, int tolerance) {
        if (otherJ < 0 || otherJ >= segmentation.rows || otherK < 0) {
            return;
        }
        int row = j + segmentation.rows * k;
        int otherRow = otherJ + segmentation.rows * otherK;
        int shift = (row - otherRow) * segmentation.columns;
        int a = firstOfRow[row];
        int b = firstOfRow[otherRow];
        while (a < firstOfRow[row + 1] && b < firstOfRow[otherRow + 1]) {
            uniteIfTouching(a, b, shift, tolerance);
            int ahead = to[a] - shift - to[b];
            if (ahead == 0 && a + 1 < firstOfRow[row + 1]) {
                // Runs that end together: the next one may touch the other at a corner.
                uniteIfTouching(a + 1, b, shift, tolerance);
            }
            if (ahead < 0) {
                a++;
            } else {
                b++;
            }
        }
    }

    private void uniteIfTouching(int a, int b, int shift, int tolerance) {
        boolean touch = from[a] - shift < to[b] + tolerance && from[b] < to[a] - shift + tolerance;
        if (touch && group(a) == group(b)) {
            DisjointSets.unionToLower(parent, a, b);
        }
    }

    /** Number of runs. */
    int count() {
        return count;
    }

    /** First voxel of a run. */
    int from(int run) {
        return from[run];
    }

    /** The voxel after the last of a run. */
    int to(int run) {
        return to[run];
    }

    /** Component of a run: the number of its first run. */
    public int component(int run) {
        return DisjointSets.find(parent, run);
    }

    /** Number of voxels of a component. */
    public int size(int component) {
        return sizes[component];
    }
}
