package org.phrenic.mesh.voxel;

import java.util.Arrays;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.IntList;

/**
 * Builds the vertices and faces of a {@link SurfaceNet} slice by slice. Cell (i, j, k) is between the centres of voxels
 * (i - 1, j - 1, k - 1) and (i, j, k).
 */
final class SurfaceNetBuilder {
    /** Edges of a cell as pairs of corners. The bits of a corner are 1 column, 2 row, 4 slice. */
    private static final int[] EDGES = {0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7};

    private static final int START = 1 << 12;

    private final LabelGrid grid;
    private final short[] partOfLabel;
    /** Cells along columns and rows. A padded slice of voxels has one more in each direction. */
    private final int wide;

    private final int high;
    private short[] below;
    private short[] above;
    private int[] lower;
    private int[] upper;
    private final DoubleList positions = new DoubleList();
    private final IntList quads = new IntList();
    private short[] sides = new short[2 * START];
    private long[] faces = new long[START];
    private int count;
    private final double[] at = new double[3];
    private final boolean mirrored;

    SurfaceNetBuilder(LabelGrid grid, int[] partOfLabel) {
        this.grid = grid;
        this.partOfLabel = new short[LabelGrid.MAX_LABEL + 1];
        for (int label = 1; label < partOfLabel.length; label++) {
            this.partOfLabel[label] = (short) partOfLabel[label];
        }
        wide = grid.columns() + 1;
        high = grid.rows() + 1;
        mirrored = grid.isMirrored();
    }

    SurfaceNet build() {
        int size = (wide + 1) * (high + 1);
        below = new short[size];
        above = new short[size];
        lower = new int[wide * high];
        upper = new int[wide * high];
        for (int k = 0; k <= grid.slices(); k++) {
            readSlice(k);
            findVertices(k);
            addFaces(k);
            short[] swap = below;
            below = above;
            above = swap;
            int[] swapped = lower;
            lower = upper;
            upper = swapped;
        }
        return new SurfaceNet(
                positions.toArray(),
                quads.toArray(),
                Arrays.copyOf(sides, 2 * count),
                Arrays.copyOf(faces, count),
                new long[] {1, wide + 1, (long) (wide + 1) * (high + 1)});
    }

    /** Reads the parts of voxel slice k, padded; all background beyond the last slice. */
    private void readSlice(int k) {
        if (k == grid.slices()) {
            Arrays.fill(above, (short) 0);
            return;
        }
        for (int j = 0; j < grid.rows(); j++) {
            int from = grid.columns() * (j + grid.rows() * k);
            int to = (wide + 1) * (j + 1) + 1;
            for (int i = 0; i < grid.columns(); i++) {
                above[to + i] = partOfLabel[grid.label(from + i)];
            }
        }
    }

    private void findVertices(int k) {
        int row = wide + 1;
        for (int j = 0; j < high; j++) {
            for (int i = 0; i < wide; i++) {
                int o = row * j + i;
                short part = below[o];
                boolean one = part == below[o + 1]
                        && part == below[o + row]
                        && part == below[o + row + 1]
                        && part == above[o]
                        && part == above[o + 1]
                        && part == above[o + row]
                        && part == above[o + row + 1];
                if (!one) {
                    upper[wide * j + i] = positions.size() / 3;
                    addVertex(i, j, k, o);
                }
            }
        }
    }

    private short corner(int o, int corner) {
        int at2 = o + (corner & 1) + ((corner & 2) == 0 ? 0 : wide + 1);
        return (corner & 4) == 0 ? below[at2] : above[at2];
    }

    private void addVertex(int i, int j, int k, int o) {
        int crossings = 0;
        double x = 0;
        double y = 0;
        double z = 0;
        for (int e = 0; e < EDGES.length; e += 2) {
            int a = EDGES[e];
            int b = EDGES[e + 1];
            if (corner(o, a) != corner(o, b)) {
                crossings++;
                x += (a & 1) + (b & 1);
                y += (a >> 1 & 1) + (b >> 1 & 1);
                z += (a >> 2) + (b >> 2);
            }
        }
        double half = 0.5 / crossings;
        grid.voxelToMm(i - 1 + half * x, j - 1 + half * y, k - 1 + half * z, at);
        positions.add(at[0], at[1], at[2]);
    }

    /** Adds the faces between voxel slices k - 1 and k, and those within slice k - 1. */
    private void addFaces(int k) {
        int row = wide + 1;
        long slice = (long) row * (high + 1) * k;
        for (int j = 0; j < high; j++) {
            for (int i = 0; i < wide; i++) {
                // Cell (i, j) owns the faces of the voxel before it.
                int o = row * j + i;
                int cell = wide * j + i;
                short part = below[o];
                if (i > 0 && j > 0 && part != above[o]) {
                    add(
                            part,
                            above[o],
                            3 * (slice + o) + 2,
                            upper[cell - wide - 1],
                            upper[cell - wide],
                            upper[cell],
                            upper[cell - 1]);
                }
                if (k > 0 && j > 0 && part != below[o + 1]) {
                    add(
                            part,
                            below[o + 1],
                            3 * (slice + o),
                            lower[cell - wide],
                            lower[cell],
                            upper[cell],
                            upper[cell - wide]);
                }
                if (k > 0 && i > 0 && part != below[o + row]) {
                    add(
                            part,
                            below[o + row],
                            3 * (slice + o) + 1,
                            lower[cell - 1],
                            upper[cell - 1],
                            upper[cell],
                            lower[cell]);
                }
            }
        }
    }

    private void add(short part, short other, long face, int a, int b, int c, int d) {
        if (count == faces.length) {
            faces = Arrays.copyOf(faces, 2 * count);
            sides = Arrays.copyOf(sides, 4 * count);
        }
        quads.add(a);
        quads.add(mirrored ? d : b);
        quads.add(c);
        quads.add(mirrored ? b : d);
        sides[2 * count] = part;
        sides[2 * count + 1] = other;
        faces[count++] = face;
    }
}
