package org.phrenic.patient;

import java.util.List;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.voxel.DistanceTransform;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * A closed surface around others, which may be open, overlap or lie apart: the cells of a cubic grid through which they
 * pass are dilated by a radius, what is enclosed is filled, and the result is eroded (morphological closing). Gaps
 * narrower than two radii are bridged.
 */
public final class SurfaceEnvelope {
    private final double cellMm;
    private final double[] low = new double[3];
    private final int[] size = new int[3];
    private final boolean[] marked;

    /**
     * An empty grid.
     *
     * @param box what will be marked lies in it: {@code {minX, minY, minZ, maxX, maxY, maxZ}}, mm
     * @param radiusMm largest radius of {@link #closed}
     * @param cellMm edge of a cell
     */
    public SurfaceEnvelope(double[] box, double radiusMm, double cellMm) {
        this.cellMm = cellMm;
        double margin = radiusMm + 2 * cellMm;
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = box[axis] - margin;
            size[axis] = (int) Math.ceil((box[3 + axis] - box[axis] + 2 * margin) / cellMm) + 1;
        }
        marked = new boolean[size[0] * size[1] * size[2]];
    }

    /**
     * The closed surface around what is marked; of parts that lie farther apart the largest.
     *
     * @param radiusMm radius of the dilation
     * @param wallMm distance of the surface from what it encloses: how much less it is eroded than dilated
     * @param edgeMm edge of the triangles
     */
    public TriangleMesh closed(double radiusMm, double wallMm, double edgeMm) {
        return mesher(radiusMm, wallMm).surface(1, edgeMm);
    }

    /** The closed surfaces around all parts of what is marked, as {@link #closed}. */
    TriangleMesh closedParts(double radiusMm, double wallMm, double edgeMm) {
        return mesher(radiusMm, wallMm).surfaceOfAll(1, edgeMm);
    }

    private SegmentMesher mesher(double radiusMm, double wallMm) {
        boolean[] outside = outside(DistanceTransform.of(marked, size), radiusMm);
        float[] toOutside = DistanceTransform.of(outside, size);
        byte[] labels = new byte[marked.length];
        for (int cell = 0; cell < labels.length; cell++) {
            labels[cell] = (byte) (toOutside[cell] * cellMm > radiusMm - wallMm ? 1 : 0);
        }
        double c = cellMm;
        LabelGrid grid = LabelGrid.of(
                size[0], size[1], size[2], labels, new double[] {c, 0, 0, low[0], 0, c, 0, low[1], 0, 0, c, low[2]});
        return new SegmentMesher(grid, new int[] {0, 1}, MeshingSettings.PAPER);
    }

    /** Cells beyond the radius that are connected with the border of the grid. */
    private boolean[] outside(float[] toMarked, double radiusMm) {
        int[] strides = {1, size[0], size[0] * size[1]};
        boolean[] outside = new boolean[marked.length];
        int[] queue = new int[marked.length];
        int tail = 0;
        outside[0] = true;
        queue[tail++] = 0;
        for (int head = 0; head < tail; head++) {
            int cell = queue[head];
            for (int axis = 0; axis < 3; axis++) {
                int at = cell / strides[axis] % size[axis];
                for (int step = -1; step <= 1; step += 2) {
                    int next = cell + step * strides[axis];
                    boolean within = at + step >= 0 && at + step < size[axis];
                    if (within && !outside[next] && toMarked[next] * cellMm > radiusMm) {
                        outside[next] = true;
                        queue[tail++] = next;
                    }
                }
            }
        }
        return outside;
    }

    /** Marks the cells that surfaces pass through. */
    public void mark(List<TriangleMesh> meshes) {
        meshes.forEach(this::mark);
    }

    private void mark(TriangleMesh mesh) {
        double[] p = mesh.positions();
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i += 3) {
            double longest = 0;
            for (int k = 0; k < 3; k++) {
                longest = Math.max(longest, MeshMeasure.distance(mesh, t[i + k], t[i + (k + 1) % 3]));
            }
            int parts = Math.max(1, (int) Math.ceil(2 * longest / cellMm));
            for (int u = 0; u <= parts; u++) {
                for (int v = 0; v <= parts - u; v++) {
                    double wa = (double) u / parts;
                    double wb = (double) v / parts;
                    double wc = 1 - wa - wb;
                    int a = 3 * t[i];
                    int b = 3 * t[i + 1];
                    int c = 3 * t[i + 2];
                    mark(
                            wa * p[a] + wb * p[b] + wc * p[c],
                            wa * p[a + 1] + wb * p[b + 1] + wc * p[c + 1],
                            wa * p[a + 2] + wb * p[b + 2] + wc * p[c + 2]);
                }
            }
        }
    }

    /** Marks the cell of a point. */
    void mark(double x, double y, double z) {
        int i = (int) Math.round((x - low[0]) / cellMm);
        int j = (int) Math.round((y - low[1]) / cellMm);
        int k = (int) Math.round((z - low[2]) / cellMm);
        boolean within = i >= 0 && i < size[0] && j >= 0 && j < size[1] && k >= 0 && k < size[2];
        if (within) {
            marked[i + size[0] * (j + size[1] * k)] = true;
        }
    }
}
