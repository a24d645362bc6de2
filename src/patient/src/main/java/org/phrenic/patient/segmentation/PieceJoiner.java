package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.phrenic.mesh.IntList;

/**
 * Joins the pieces of a bone: from the largest piece a search spreads through background, and each piece within reach
 * is joined by a bridge of voxels: a straight one, or where another structure cuts that through one along the path by
 * which the search went round it. A path leads across faces of voxels, so that what a bridge joins is one piece.
 */
final class PieceJoiner {
    /** Half the thickness of a bridge, mm; at least half a voxel. */
    private static final double BRIDGE_MM = 2;
    /** Rounding of distances, as spacings in files are rounded, mm. */
    private static final double ROUNDING_MM = 0.001;

    private static final int BLOCKED = -1;

    private final Segmentation s;
    private final byte segment;
    /** By segment number, whether bridges may take its voxels. */
    private final boolean[] free;

    private final double reachMm;
    private final int[] low;
    private final int[] size;
    /** Piece of each cell of the box, from 1; 0 is background, {@link #BLOCKED} another structure. */
    private final int[] pieces;
    /** Cell of the joined pieces from which the search reached a cell. */
    private final int[] origin;
    /** Cell before a cell on the path from its origin. */
    private final int[] previous;

    private final IntList queue = new IntList();
    private final boolean[] joined;

    /**
     * Prepares the pieces of a segment.
     *
     * @param components the pieces as lists of voxels, the largest first
     * @param reachMm largest distance that is bridged, from voxel to voxel, mm
     * @param free by segment number, whether it counts as background
     */
    PieceJoiner(Segmentation s, int segment, List<int[]> components, double reachMm, boolean[] free) {
        this.s = s;
        this.segment = (byte) segment;
        this.free = free;
        this.reachMm = reachMm;
        int[] box = s.box(segment);
        int[] all = {s.columns, s.rows, s.slices};
        PieceBoxes near = new PieceBoxes(s, components, reachMm + ROUNDING_MM);
        low = new int[3];
        size = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            // A margin of two voxels lets the search pass around a corner of the bone.
            low[axis] = Math.max(Math.max(0, box[axis] - 2), near.reached()[axis]);
            size[axis] = Math.min(Math.min(all[axis] - 1, box[3 + axis] + 2), near.reached()[3 + axis]) - low[axis] + 1;
        }
        pieces = new int[size[0] * size[1] * size[2]];
        origin = new int[pieces.length];
        previous = new int[pieces.length];
        Arrays.fill(origin, BLOCKED);
        for (int cell = 0; cell < pieces.length; cell++) {
            pieces[cell] = free[s.segmentAt(voxel(cell))] ? 0 : BLOCKED;
        }
        joined = new boolean[components.size() + 1];
        for (int piece = 1; piece < joined.length; piece++) {
            for (int v : near.isNear(piece - 1) ? components.get(piece - 1) : new int[0]) {
                pieces[cell(v)] = piece;
            }
        }
        start(components.get(0), 1);
        search(components);
    }

    private int[] index(int cell) {
        return new int[] {cell % size[0], cell / size[0] % size[1], cell / size[0] / size[1]};
    }

    private int voxel(int cell) {
        int[] at = index(cell);
        return low[0] + at[0] + s.columns * (low[1] + at[1] + s.rows * (low[2] + at[2]));
    }

    private int cell(int voxel) {
        int i = voxel % s.columns - low[0];
        int j = voxel / s.columns % s.rows - low[1];
        int k = voxel / s.columns / s.rows - low[2];
        return i + size[0] * (j + size[1] * k);
    }

    private void start(int[] voxels, int piece) {
        joined[piece] = true;
        for (int v : voxels) {
            int cell = cell(v);
            origin[cell] = cell;
            previous[cell] = cell;
            queue.add(cell);
        }
    }

    private void search(List<int[]> components) {
        for (int at = 0; at < queue.size(); at++) {
            int cell = queue.get(at);
            int[] from = index(cell);
            for (int neighbour = 0; neighbour < 27; neighbour++) {
                int x = from[0] + neighbour % 3 - 1;
                int y = from[1] + neighbour / 3 % 3 - 1;
                int z = from[2] + neighbour / 9 - 1;
                if (x >= 0 && x < size[0] && y >= 0 && y < size[1] && z >= 0 && z < size[2]) {
                    reach(cell, x + size[0] * (y + size[1] * z), components);
                }
            }
        }
    }

    private void reach(int from, int cell, List<int[]> components) {
        if (origin[cell] != BLOCKED
                || pieces[cell] == BLOCKED
                || distance(origin[from], cell) > reachMm + ROUNDING_MM
                || !leads(from, cell, new IntList())) {
            return;
        }
        if (pieces[cell] == 0) {
            origin[cell] = origin[from];
            previous[cell] = from;
            queue.add(cell);
        } else if (!joined[pieces[cell]]) {
            bridge(from, cell);
            start(components.get(pieces[cell] - 1), pieces[cell]);
        }
    }

    /** Distance between two cells, mm. */
    private double distance(int a, int b) {
        double square = 0;
        for (int row = 0; row < 3; row++) {
            double d = s.coordinate(voxel(a), row) - s.coordinate(voxel(b), row);
            square += d * d;
        }
        return Math.sqrt(square);
    }

    /**
     * Whether a way across faces leads from a cell to one of the 26 about it past other structures.
     *
     * @param way receives its cells
     */
    private boolean leads(int from, int to, IntList way) {
        if (from == to) {
            return true;
        }
        int[] at = index(from);
        int[] last = index(to);
        int stride = 1;
        for (int axis = 0; axis < 3; axis++) {
            int next = from + stride * (last[axis] - at[axis]);
            if (next != from && pieces[next] != BLOCKED && leads(next, to, way)) {
                way.add(next);
                return true;
            }
            stride *= size[axis];
        }
        return false;
    }

    /** Fills what is free about the line from the origin of a cell to another, or about the path if that leads on. */
    private void bridge(int from, int to) {
        BitSet bridge = about(line(origin[from], to));
        if (!connects(bridge, origin[from], to)) {
            IntList path = new IntList();
            leads(from, to, path);
            for (int cell = from; cell != previous[cell]; cell = previous[cell]) {
                leads(previous[cell], cell, path);
            }
            bridge = about(path);
        }
        bridge.stream().map(this::voxel).filter(v -> free[s.segmentAt(v)]).forEach(v -> s.voxels[v] = segment);
    }

    private IntList line(int from, int to) {
        int[] first = index(from);
        int[] last = index(to);
        int steps = 1;
        for (int axis = 0; axis < 3; axis++) {
            steps = Math.max(steps, 2 * Math.abs(last[axis] - first[axis]));
        }
        IntList line = new IntList();
        for (int step = 0; step <= steps; step++) {
            int[] at = new int[3];
            for (int axis = 0; axis < 3; axis++) {
                at[axis] = (int) Math.round(first[axis] + (double) step / steps * (last[axis] - first[axis]));
            }
            line.add(at[0] + size[0] * (at[1] + size[1] * at[2]));
        }
        return line;
    }

    /** The cells of no other structure within half a bridge's thickness of some cells. */
    private BitSet about(IntList cells) {
        int[] half = new int[3];
        Arrays.setAll(half, axis -> (int) Math.round(BRIDGE_MM / s.grid().spacing(axis)));
        BitSet about = new BitSet();
        for (int n = 0; n < cells.size(); n++) {
            int[] at = index(cells.get(n));
            for (int z = Math.max(0, at[2] - half[2]); z <= Math.min(size[2] - 1, at[2] + half[2]); z++) {
                for (int y = Math.max(0, at[1] - half[1]); y <= Math.min(size[1] - 1, at[1] + half[1]); y++) {
                    for (int x = Math.max(0, at[0] - half[0]); x <= Math.min(size[0] - 1, at[0] + half[0]); x++) {
                        int cell = x + size[0] * (y + size[1] * z);
                        about.set(cell, pieces[cell] != BLOCKED);
                    }
                }
            }
        }
        return about;
    }

    /** Whether some cells lead from one of them to another across faces. */
    private boolean connects(BitSet cells, int from, int to) {
        BitSet left = (BitSet) cells.clone();
        IntList reached = new IntList();
        reached.add(from);
        left.clear(from);
        for (int n = 0; n < reached.size(); n++) {
            int[] at = index(reached.get(n));
            int stride = 1;
            for (int axis = 0; axis < 3; axis++) {
                for (int side = -1; side <= 1; side += 2) {
                    int next = reached.get(n) + side * stride;
                    boolean inside = at[axis] + side >= 0 && at[axis] + side < size[axis];
                    if (inside && left.get(next)) {
                        left.clear(next);
                        reached.add(next);
                    }
                }
                stride *= size[axis];
            }
        }
        return cells.get(to) && !left.get(to);
    }

    /** Indices, in the list given, of the pieces that no bridge reached. */
    List<Integer> unreached() {
        List<Integer> left = new ArrayList<>();
        for (int piece = 1; piece < joined.length; piece++) {
            if (!joined[piece]) {
                left.add(piece - 1);
            }
        }
        return left;
    }
}
