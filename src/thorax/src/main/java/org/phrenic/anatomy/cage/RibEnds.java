package org.phrenic.anatomy.cage;

import java.util.Arrays;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.IndexedPriorityQueue;
import org.phrenic.mesh.TriangleMesh;

/**
 * The two ends of a rib, found from its surface: the head, at the vertebra, and the anterior end, at the cartilage.
 *
 * <p>The ends are the two points with the largest distance along edges. Vertices are clustered into cells of about a
 * hundredth of the rib's length. Edges link neighbouring cells, cells that share a triangle, and the nearest cells of
 * disconnected patches, so that seams and holes do not matter. Two Dijkstra sweeps find the longest shortest path. An
 * end is the mean of the vertices within {@value #END_REGION_MM} mm of the farthest one, along the rib. The head is the
 * more posterior, superior and medial end; of a part of a rib in front, the end toward the head is not the medial one.
 */
public final class RibEnds {
    /** About half the thickness of a rib, mm, so that an end is not defined by a single vertex. */
    static final double END_REGION_MM = 5;

    /** Cells along the diagonal of the rib's bounding box: 3 to 4 mm for a middle rib, less than its thickness. */
    private static final int CELLS_ALONG = 80;

    private final double[] head;
    private final double[] anterior;
    private final double lengthMm;

    private RibEnds(double[] head, double[] anterior, double lengthMm) {
        this.head = head;
        this.anterior = anterior;
        this.lengthMm = lengthMm;
    }

    /**
     * Finds the ends of a rib.
     *
     * @param rib surface in LPS, mm; may be open and consist of several patches
     * @param side right or left
     * @throws IllegalArgumentException if the mesh has no extent or the side is the midline
     */
    public static RibEnds find(TriangleMesh rib, Side side) {
        return stations(rib, side).ends();
    }

    /**
     * Distance of each vertex from the head along the rib, mm: the mean of what the distances along edges from both
     * ends give.
     *
     * @param lengthMm length from end to end, mm
     */
    record Stations(RibEnds ends, double[] along, double lengthMm) {}

    static Stations stations(TriangleMesh rib, Side side) {
        if (side == Side.MIDLINE) {
            throw new IllegalArgumentException("rib: side MIDLINE, expected RIGHT or LEFT");
        }
        double[] box = rib.bounds();
        double diagonal = Math.sqrt(square(box[3] - box[0]) + square(box[4] - box[1]) + square(box[5] - box[2]));
        if (!(diagonal > 0) || Double.isInfinite(diagonal)) {
            throw new IllegalArgumentException(
                    "rib: a mesh of " + rib.vertexCount() + " vertices without extent, expected the surface of a rib");
        }
        Cells cells = new Cells(rib, diagonal / CELLS_ALONG);
        double[] fromOne = cells.distances(farthest(cells.fromFirst));
        double[] fromOther = cells.distances(farthest(fromOne));
        double[] one = cells.region(fromOther);
        double[] other = cells.region(fromOne);
        double length = fromOne[farthest(fromOne)];
        boolean oneIsHead = towardHead(one, side) > towardHead(other, side);
        RibEnds ends = oneIsHead ? new RibEnds(one, other, length) : new RibEnds(other, one, length);
        double[] fromHead = oneIsHead ? fromOne : fromOther;
        double[] fromAnterior = oneIsHead ? fromOther : fromOne;
        double[] along = new double[rib.vertexCount()];
        for (int v = 0; v < along.length; v++) {
            int cell = cells.cellOf[v];
            along[v] = (fromHead[cell] + length - fromAnterior[cell]) / 2;
        }
        return new Stations(ends, along, length);
    }

    /** Centre of the head, LPS, mm. */
    public double[] head() {
        return head.clone();
    }

    /** Centre of the anterior end, LPS, mm. */
    public double[] anterior() {
        return anterior.clone();
    }

    /** Length along the surface from end to end, mm; a few per cent longer than the centre line. */
    public double lengthMm() {
        return lengthMm;
    }

    /** Posterior is +y, superior +z; medial is opposite to the sign of the side. */
    private static double towardHead(double[] end, Side side) {
        return end[1] + end[2] - side.sign() * end[0];
    }

    private static int farthest(double[] distances) {
        int best = 0;
        for (int i = 1; i < distances.length; i++) {
            if (distances[i] > distances[best]) {
                best = i;
            }
        }
        return best;
    }

    private static double square(double value) {
        return value * value;
    }

    /** Graph of cells; the position of a cell is the mean of its vertices. */
    private static final class Cells {
        private static final int NONE = -1;
        private final TriangleMesh rib;
        private final int[] cellOf;
        private final double[] centres;
        /** Neighbours of each cell; {@code linkCount} holds their numbers. */
        private int[][] links = new int[256][];

        private int[] linkCount = new int[256];
        private int count;
        /** Distance of each cell from the first. */
        private final double[] fromFirst;

        Cells(TriangleMesh rib, double size) {
            this.rib = rib;
            double[] box = rib.bounds();
            // One extra cell on each side, so that every cell has all neighbours on the grid.
            int[] grid = new int[3];
            for (int axis = 0; axis < 3; axis++) {
                grid[axis] = (int) ((box[3 + axis] - box[axis]) / size) + 3;
            }
            int[] cells = new int[grid[0] * grid[1] * grid[2]];
            Arrays.fill(cells, NONE);
            cellOf = new int[rib.vertexCount()];
            int[] place = new int[cellOf.length];
            for (int v = 0; v < cellOf.length; v++) {
                int i = (int) ((rib.x(v) - box[0]) / size) + 1;
                int j = (int) ((rib.y(v) - box[1]) / size) + 1;
                int k = (int) ((rib.z(v) - box[2]) / size) + 1;
                int at = (i * grid[1] + j) * grid[2] + k;
                if (cells[at] == NONE) {
                    place[count] = at;
                    cells[at] = count;
                    addCell();
                }
                cellOf[v] = cells[at];
            }
            centres = means();
            linkNeighbours(cells, place, grid);
            linkTriangles();
            fromFirst = bridgePatches();
        }

        private void addCell() {
            if (count == links.length) {
                links = Arrays.copyOf(links, 2 * count);
                linkCount = Arrays.copyOf(linkCount, 2 * count);
            }
            links[count++] = new int[32];
        }

        private double[] means() {
            double[] sums = new double[3 * count];
            int[] counts = new int[count];
            for (int v = 0; v < cellOf.length; v++) {
                counts[cellOf[v]]++;
                for (int axis = 0; axis < 3; axis++) {
                    sums[3 * cellOf[v] + axis] += rib.positions()[3 * v + axis];
                }
            }
            for (int i = 0; i < sums.length; i++) {
                sums[i] /= counts[i / 3];
            }
            return sums;
        }

        private void linkNeighbours(int[] cells, int[] place, int[] grid) {
            for (int c = 0; c < count; c++) {
                for (int i = -1; i <= 1; i++) {
                    for (int j = -1; j <= 1; j++) {
                        int row = place[c] + (i * grid[1] + j) * grid[2];
                        for (int at = row - 1; at <= row + 1; at++) {
                            if (cells[at] != NONE) {
                                link(c, cells[at]);
                            }
                        }
                    }
                }
            }
        }

        private void linkTriangles() {
            int[] t = rib.triangles();
            for (int i = 0; i < t.length; i += 3) {
                link(cellOf[t[i]], cellOf[t[i + 1]]);
                link(cellOf[t[i + 1]], cellOf[t[i + 2]]);
                link(cellOf[t[i + 2]], cellOf[t[i]]);
            }
        }

        private void link(int a, int b) {
            if (a == b) {
                return;
            }
            for (int k = 0; k < linkCount[a]; k++) {
                if (links[a][k] == b) {
                    return;
                }
            }
            add(a, b);
            add(b, a);
        }

        private void add(int cell, int other) {
            if (linkCount[cell] == links[cell].length) {
                links[cell] = Arrays.copyOf(links[cell], 2 * linkCount[cell]);
            }
            links[cell][linkCount[cell]++] = other;
        }

        /**
         * Links the component of the first cell to the nearest cell outside it until all cells are connected. Returns
         * the distances from the first cell.
         */
        private double[] bridgePatches() {
            boolean[] reached = new boolean[count];
            int inReach = spread(0, reached);
            while (inReach < count) {
                double nearest = Double.POSITIVE_INFINITY;
                int inside = -1;
                int outside = -1;
                for (int a = 0; a < reached.length; a++) {
                    for (int b = 0; b < reached.length && reached[a]; b++) {
                        if (!reached[b] && distance(a, b) < nearest) {
                            nearest = distance(a, b);
                            inside = a;
                            outside = b;
                        }
                    }
                }
                link(inside, outside);
                inReach += spread(outside, reached);
            }
            return distances(0);
        }

        /** Marks the connected component of a cell; returns the number of newly marked cells. */
        private int spread(int from, boolean[] reached) {
            int[] queue = new int[reached.length];
            queue[0] = from;
            reached[from] = true;
            int tail = 1;
            for (int head = 0; head < tail; head++) {
                for (int k = 0; k < linkCount[queue[head]]; k++) {
                    int next = links[queue[head]][k];
                    if (!reached[next]) {
                        reached[next] = true;
                        queue[tail++] = next;
                    }
                }
            }
            return tail;
        }

        /** Distance along edges of the rib from a cell to each cell, mm. */
        double[] distances(int start) {
            double[] found = new double[count];
            Arrays.fill(found, Double.POSITIVE_INFINITY);
            found[start] = 0;
            IndexedPriorityQueue heap = new IndexedPriorityQueue(found);
            heap.insertOrDecrease(start);
            while (!heap.isEmpty()) {
                int cell = heap.removeMin();
                for (int k = 0; k < linkCount[cell]; k++) {
                    int next = links[cell][k];
                    double along = found[cell] + distance(cell, next);
                    if (along < found[next]) {
                        found[next] = along;
                        heap.insertOrDecrease(next);
                    }
                }
            }
            return found;
        }

        /** Mean of the vertices of the farthest cells. */
        double[] region(double[] distances) {
            double limit = distances[farthest(distances)] - END_REGION_MM;
            double[] mean = new double[3];
            int vertices = 0;
            for (int v = 0; v < cellOf.length; v++) {
                if (distances[cellOf[v]] >= limit) {
                    mean[0] += rib.x(v);
                    mean[1] += rib.y(v);
                    mean[2] += rib.z(v);
                    vertices++;
                }
            }
            return new double[] {mean[0] / vertices, mean[1] / vertices, mean[2] / vertices};
        }

        private double distance(int a, int b) {
            return Math.sqrt(square(centres[3 * a] - centres[3 * b])
                    + square(centres[3 * a + 1] - centres[3 * b + 1])
                    + square(centres[3 * a + 2] - centres[3 * b + 2]));
        }
    }
}
