package org.phrenic.anatomy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.phrenic.geometry.TriangleMesh;

/**
 * The two ends of a rib, found from its surface: the head, at the vertebra, and the anterior end, at the cartilage.
 *
 * <p>The ends are the two points of the rib farthest apart along it: vertices are gathered into cells of about a hundredth of
 * the rib, neighbouring cells are linked (and cells that share a triangle, and the nearest cells of patches that touch
 * nowhere, so that seams and holes do not matter), and the longest of the shortest paths is sought by two sweeps of
 * Dijkstra's method. An end is the mean of the vertices within {@value #END_REGION_MM} mm of the farthest one, along the rib.
 * The head is the end that lies more posterior and medial.
 */
public final class RibEnds {
    /** Half of the thickness of a rib or so: the end as a whole, not its sharpest vertex. */
    static final double END_REGION_MM = 5;

    /** Cells along the diagonal of the rib's box: 3 to 4 mm for a middle rib, finer than it is thick. */
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
     * @param rib surface in LPS, mm; it may be in several patches and open
     * @param side of the body, right or left
     * @throws IllegalArgumentException if the mesh has no extent or the side is the midline
     */
    public static RibEnds find(TriangleMesh rib, Side side) {
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
        // Posterior is +y; medial is away from the sign of the side.
        boolean oneIsHead = one[1] - side.sign() * one[0] > other[1] - side.sign() * other[0];
        return oneIsHead ? new RibEnds(one, other, length) : new RibEnds(other, one, length);
    }

    /** Centre of the head, LPS, mm. */
    public double[] head() {
        return head.clone();
    }

    /** Centre of the anterior end, LPS, mm. */
    public double[] anterior() {
        return anterior.clone();
    }

    /** Length along the surface from end to end, mm; some per cent above that of the centre line. */
    public double lengthMm() {
        return lengthMm;
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

    /** The graph of cells: each stands at the mean of its vertices. */
    private static final class Cells {
        private final TriangleMesh rib;
        private final int[] cellOf;
        private final double[] centres;
        private final List<List<Integer>> links = new ArrayList<>();
        /** Distance of each cell from the first. */
        private final double[] fromFirst;

        Cells(TriangleMesh rib, double size) {
            this.rib = rib;
            double[] box = rib.bounds();
            Map<Long, Integer> cells = new HashMap<>();
            List<long[]> places = new ArrayList<>();
            cellOf = new int[rib.vertexCount()];
            for (int v = 0; v < cellOf.length; v++) {
                long[] place = {
                    (long) ((rib.x(v) - box[0]) / size),
                    (long) ((rib.y(v) - box[1]) / size),
                    (long) ((rib.z(v) - box[2]) / size)
                };
                Integer known = cells.putIfAbsent(key(place[0], place[1], place[2]), places.size());
                if (known == null) {
                    cellOf[v] = places.size();
                    places.add(place);
                    links.add(new ArrayList<>());
                } else {
                    cellOf[v] = known;
                }
            }
            centres = means();
            linkNeighbours(cells, places);
            for (int t = 0; t < rib.triangles().length; t += 3) {
                for (int k = 0; k < 3; k++) {
                    link(cellOf[rib.triangles()[t + k]], cellOf[rib.triangles()[t + (k + 1) % 3]]);
                }
            }
            fromFirst = bridgePatches();
        }

        private static long key(long i, long j, long k) {
            return (i * 1024 + j) * 1024 + k;
        }

        private double[] means() {
            double[] sums = new double[3 * links.size()];
            int[] counts = new int[links.size()];
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

        private void linkNeighbours(Map<Long, Integer> cells, List<long[]> places) {
            for (int c = 0; c < places.size(); c++) {
                long[] p = places.get(c);
                for (long i = -1; i <= 1; i++) {
                    for (long j = -1; j <= 1; j++) {
                        for (long k = -1; k <= 1; k++) {
                            Integer other = cells.get(key(p[0] + i, p[1] + j, p[2] + k));
                            if (other != null) {
                                link(c, other);
                            }
                        }
                    }
                }
            }
        }

        private void link(int a, int b) {
            if (a != b && !links.get(a).contains(b)) {
                links.get(a).add(b);
                links.get(b).add(a);
            }
        }

        /** Links the patch of the first cell to the nearest cell outside it until there is none outside; returns the distances from the first cell. */
        private double[] bridgePatches() {
            boolean[] reached = new boolean[links.size()];
            int count = spread(0, reached);
            while (count < reached.length) {
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
                count += spread(outside, reached);
            }
            return distances(0);
        }

        /** Marks what hangs together with a cell; returns how many were not marked before. */
        private int spread(int from, boolean[] reached) {
            int[] queue = new int[reached.length];
            queue[0] = from;
            reached[from] = true;
            int tail = 1;
            for (int head = 0; head < tail; head++) {
                for (int next : links.get(queue[head])) {
                    if (!reached[next]) {
                        reached[next] = true;
                        queue[tail++] = next;
                    }
                }
            }
            return tail;
        }

        /** Distance along the rib from a cell to each, mm; -1 where there is no way. */
        double[] distances(int start) {
            double[] found = new double[links.size()];
            Arrays.fill(found, -1);
            record Visit(int cell, double distance) {}
            PriorityQueue<Visit> queue = new PriorityQueue<>(
                    Comparator.comparingDouble(Visit::distance).thenComparingInt(Visit::cell));
            queue.add(new Visit(start, 0));
            while (!queue.isEmpty()) {
                Visit visit = queue.poll();
                if (found[visit.cell()] >= 0) {
                    continue;
                }
                found[visit.cell()] = visit.distance();
                for (int next : links.get(visit.cell())) {
                    if (found[next] < 0) {
                        queue.add(new Visit(next, visit.distance() + distance(visit.cell(), next)));
                    }
                }
            }
            return found;
        }

        /** Mean of the vertices of the cells that are farthest. */
        double[] region(double[] distances) {
            double limit = distances[farthest(distances)] - END_REGION_MM;
            double[] mean = new double[3];
            int count = 0;
            for (int v = 0; v < cellOf.length; v++) {
                if (distances[cellOf[v]] >= limit) {
                    mean[0] += rib.x(v);
                    mean[1] += rib.y(v);
                    mean[2] += rib.z(v);
                    count++;
                }
            }
            return new double[] {mean[0] / count, mean[1] / count, mean[2] / count};
        }

        private double distance(int a, int b) {
            return Math.sqrt(square(centres[3 * a] - centres[3 * b])
                    + square(centres[3 * a + 1] - centres[3 * b + 1])
                    + square(centres[3 * a + 2] - centres[3 * b + 2]));
        }
    }
}
