package org.phrenic.model.organ;

import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;

/**
 * Nearest-neighbour search among chosen vertices of a mesh, on a uniform grid searched shell by shell. Not thread-safe.
 */
public final class NearestVertex {
    private static final double CELL_MM = 10;
    private static final double SLACK_MM = 1e-6;

    private final TriangleMesh mesh;
    private final double[] box;
    private final int[] cells;
    private final int[] start;
    private final int[] vertex;
    private double distance;

    public NearestVertex(TriangleMesh mesh, IntPredicate chosen) {
        this.mesh = mesh;
        box = mesh.bounds();
        cells = new int[] {
            (int) ((box[3] - box[0]) / CELL_MM) + 1,
            (int) ((box[4] - box[1]) / CELL_MM) + 1,
            (int) ((box[5] - box[2]) / CELL_MM) + 1
        };
        start = new int[cells[0] * cells[1] * cells[2] + 1];
        int[] picked = IntStream.range(0, mesh.vertexCount()).filter(chosen).toArray();
        for (int v : picked) {
            start[cellOf(v) + 1]++;
        }
        for (int c = 1; c < start.length; c++) {
            start[c] += start[c - 1];
        }
        vertex = new int[picked.length];
        int[] next = start.clone();
        for (int v : picked) {
            vertex[next[cellOf(v)]++] = v;
        }
    }

    private int cellOf(int v) {
        return (index(mesh.x(v), 0) * cells[1] + index(mesh.y(v), 1)) * cells[2] + index(mesh.z(v), 2);
    }

    private int index(double value, int axis) {
        return Math.max(0, Math.min(cells[axis] - 1, (int) ((value - box[axis]) / CELL_MM)));
    }

    /** Number of the nearest chosen vertex at any distance; -1 if no vertex is chosen. */
    public int find(double x, double y, double z) {
        return find(x, y, z, Double.POSITIVE_INFINITY);
    }

    /**
     * Number of the nearest chosen vertex within a distance.
     *
     * @param reach search radius, mm
     * @return -1 if none lies within the radius; a vertex slightly beyond it may be returned
     */
    int find(double x, double y, double z, double reach) {
        int cx = index(x, 0);
        int cy = index(y, 1);
        int cz = index(z, 2);
        int most = Math.max(cells[0], Math.max(cells[1], cells[2]));
        int best = -1;
        double bestSquared = Double.POSITIVE_INFINITY;
        double outside = distanceToBox(x, y, z);
        for (int shell = 0; shell <= most; shell++) {
            // Lower bound on the distance of everything in this shell and the later ones.
            double least = Math.max(outside, (shell - 1.0) * CELL_MM);
            if (least > reach || (best >= 0 && bestSquared < (shell - 1.0) * (shell - 1.0) * CELL_MM * CELL_MM)) {
                break;
            }
            for (int i = Math.max(0, cx - shell); i <= Math.min(cells[0] - 1, cx + shell); i++) {
                for (int j = Math.max(0, cy - shell); j <= Math.min(cells[1] - 1, cy + shell); j++) {
                    // In columns that earlier shells have visited, only the two end cells are new.
                    boolean inner = Math.abs(i - cx) < shell && Math.abs(j - cy) < shell;
                    int stride = inner ? 2 * shell : 1;
                    int first = inner || cz >= shell ? cz - shell : 0;
                    for (int k = first; k <= Math.min(cells[2] - 1, cz + shell); k += stride) {
                        int cell = (i * cells[1] + j) * cells[2] + k;
                        if (k < 0
                                || start[cell] == start[cell + 1]
                                || squaredDistanceToCell(i, j, k, x, y, z) > bestSquared) {
                            continue;
                        }
                        for (int n = start[cell]; n < start[cell + 1]; n++) {
                            int v = vertex[n];
                            double dx = mesh.x(v) - x;
                            double dy = mesh.y(v) - y;
                            double dz = mesh.z(v) - z;
                            double squared = dx * dx + dy * dy + dz * dz;
                            if (squared < bestSquared) {
                                bestSquared = squared;
                                best = v;
                            }
                        }
                    }
                }
            }
        }
        distance = Math.sqrt(bestSquared);
        return best;
    }

    /** Squared distance from a cell, reduced slightly so that rounding misses no vertex on the cell's face. */
    private double squaredDistanceToCell(int i, int j, int k, double x, double y, double z) {
        double dx = distanceToSlab(i, x - box[0]);
        double dy = distanceToSlab(j, y - box[1]);
        double dz = distanceToSlab(k, z - box[2]);
        return dx * dx + dy * dy + dz * dz;
    }

    private static double distanceToSlab(int cell, double from) {
        double away = BoundingBoxes.intervalDistance(cell * CELL_MM, (cell + 1) * CELL_MM, from) - SLACK_MM;
        return away > 0 ? away : 0;
    }

    private double distanceToBox(double x, double y, double z) {
        return Math.sqrt(BoundingBoxes.squaredDistance(box, 0, x, y, z));
    }

    /** Distance of the last vertex found, mm; infinite if none was found. */
    public double distance() {
        return distance;
    }
}
