package org.phrenic.access.ultrasound;

import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.MovingLeastSquares;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Displacement from where a point of a tissue is to where it is at rest, at nodes of a coarse grid in the image plane.
 * For a rigid surface it is that of the inverse pose. Inside a deforming surface it is interpolated from
 * {@value #ANCHORS} of its vertices, spread evenly, by {@link MovingLeastSquares} about their current positions: exact
 * for an affine motion. Tissue between organs follows the skin and, by {@value #POOLED_ANCHORS} vertices each, all
 * other surfaces that deform.
 */
final class MaterialMotion {
    /** Lines from node to node. */
    static final int LINE_STEP = 17;
    /** Samples from node to node. */
    static final int SAMPLE_STEP = 32;

    static final int LINE_NODES = SectorGrid.LINES / LINE_STEP + 1;
    static final int SAMPLE_NODES = SectorGrid.SAMPLES / SAMPLE_STEP + 1;
    private static final int ANCHORS = 100;
    private static final int POOLED_ANCHORS = 20;

    private final List<SonatedSurface> surfaces;
    private final int[][] anchors;
    private final double[][] restAnchors;
    private final double[][] nowAnchors;
    private final int[] pooled;
    private final double[][] boxes;
    private final float[][] poses;
    private final double[][] displacements;
    /** Nodes farther than this from the box of a surface are of no use to it, mm. */
    private double marginMm;

    private final double[] nodes = new double[3 * LINE_NODES * SAMPLE_NODES];

    MaterialMotion(List<SonatedSurface> surfaces) {
        this.surfaces = surfaces;
        int n = surfaces.size();
        anchors = new int[n][];
        restAnchors = new double[n][];
        nowAnchors = new double[n][];
        boxes = new double[n][];
        poses = new float[n][];
        displacements = new double[n][];
        for (int i = 0; i < n; i++) {
            Surface surface = surfaces.get(i).surface;
            anchors[i] = surface.motion() == Surface.Motion.DEFORMING
                    ? spread(surface.rest().positions())
                    : new int[0];
            restAnchors[i] = Vectors.gather(surface.rest().positions(), anchors[i]);
            nowAnchors[i] = restAnchors[i].clone();
            displacements[i] = new double[nodes.length];
        }
        pooled = java.util.stream.IntStream.range(0, n)
                .filter(i -> anchors[i].length > 0)
                .toArray();
    }

    /** Vertices that lie as far from each other as can be: each is the farthest from those before it. */
    private static int[] spread(double[] p) {
        int n = p.length / 3;
        int[] chosen = new int[Math.min(n, ANCHORS)];
        double[] nearest = new double[n];
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        for (int k = 1; k < chosen.length; k++) {
            int farthest = 0;
            for (int v = 0; v < n; v++) {
                int last = chosen[k - 1];
                double x = p[3 * v] - p[3 * last];
                double y = p[3 * v + 1] - p[3 * last + 1];
                double z = p[3 * v + 2] - p[3 * last + 2];
                nearest[v] = Math.min(nearest[v], x * x + y * y + z * z);
                farthest = nearest[v] > nearest[farthest] ? v : farthest;
            }
            chosen[k] = farthest;
        }
        return chosen;
    }

    /** Takes the positions of a frame; the surfaces are already there. */
    void update(Frame frame, ProbePose pose, SectorGrid grid, int threads) {
        double radius = grid.probe.radiusMm();
        marginMm = LINE_STEP * grid.lineSpacingMm(grid.depthMm) + SAMPLE_STEP * grid.stepMm;
        for (int i = 0; i < LINE_NODES; i++) {
            double angle = grid.angle(i * LINE_STEP);
            double sin = StrictMath.sin(angle);
            double cos = StrictMath.cos(angle);
            for (int s = 0; s < SAMPLE_NODES; s++) {
                double range = radius + s * SAMPLE_STEP * grid.stepMm;
                double[] at = pose.toWorld(range * sin, range * cos - radius, 0);
                System.arraycopy(at, 0, nodes, 3 * (i * SAMPLE_NODES + s), 3);
            }
        }
        for (SonatedSurface s : surfaces) {
            boxes[s.index] = s.surface.rest().withPositions(s.world()).bounds();
            poses[s.index] = s.surface.motion() == Surface.Motion.RIGID ? frame.pose(s.index) : new float[0];
            nowAnchors[s.index] = Vectors.gather(s.world(), anchors[s.index]);
        }
        double[] pooledNow = concatenate(nowAnchors);
        double[] pooledRest = concatenate(restAnchors);
        Bands.run(LINE_NODES * SAMPLE_NODES, threads, (from, to) -> {
            for (int node = from; node < to; node++) {
                for (SonatedSurface s : surfaces) {
                    displace(s, node, pooledNow, pooledRest);
                }
            }
        });
    }

    private double[] concatenate(double[][] parts) {
        DoubleList all = new DoubleList();
        for (int i : pooled) {
            boolean skin = surfaces.get(i).surface.kind() == StructureKind.SKIN;
            int length = skin ? parts[i].length : Math.min(parts[i].length, 3 * POOLED_ANCHORS);
            for (int k = 0; k < length; k++) {
                all.add(parts[i][k]);
            }
        }
        return all.toArray();
    }

    private void displace(SonatedSurface s, int node, double[] pooledNow, double[] pooledRest) {
        double[] place = {nodes[3 * node], nodes[3 * node + 1], nodes[3 * node + 2]};
        double[] out = displacements[s.index];
        Arrays.fill(out, 3 * node, 3 * node + 3, 0);
        double[] box = boxes[s.index];
        for (int axis = 0; axis < 3; axis++) {
            if (place[axis] < box[axis] - marginMm || place[axis] > box[3 + axis] + marginMm) {
                return;
            }
        }
        boolean skin = s.surface.kind() == StructureKind.SKIN;
        if (poses[s.index].length > 0) {
            float[] p = poses[s.index];
            for (int axis = 0; axis < 3; axis++) {
                double rest = 0;
                for (int row = 0; row < 3; row++) {
                    rest += p[4 * row + axis] * (place[row] - p[4 * row + 3]);
                }
                out[3 * node + axis] = rest - place[axis];
            }
        } else if (skin ? pooled.length > 0 : anchors[s.index].length > 0) {
            double[] now = skin ? pooledNow : nowAnchors[s.index];
            double[] rest = skin ? pooledRest : restAnchors[s.index];
            double[] at = MovingLeastSquares.position(MovingLeastSquares.coefficients(now, place), rest);
            for (int axis = 0; axis < 3; axis++) {
                out[3 * node + axis] = at[axis] - place[axis];
            }
        }
    }

    /**
     * Displacement to the place at rest on a scan line, mm.
     *
     * @param surface whose tissue it is
     * @param node number of the node along the line
     */
    void at(int surface, int line, int node, double[] out) {
        int low = line / LINE_STEP;
        double share = line / (double) LINE_STEP - low;
        double[] d = displacements[surface];
        int a = 3 * (low * SAMPLE_NODES + node);
        int b = 3 * (Math.min(low + 1, LINE_NODES - 1) * SAMPLE_NODES + node);
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = (1 - share) * d[a + axis] + share * d[b + axis];
        }
    }
}
