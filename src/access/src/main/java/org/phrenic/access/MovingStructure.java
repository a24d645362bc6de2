package org.phrenic.access;

import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * One moving surface. The tree of a deforming surface is refitted to each frame; for a rigid one the query is
 * transformed into the axes of the surface at rest.
 */
public final class MovingStructure {
    /** Rounding of a box transformed by a pose in single precision. */
    private static final double BOX_TOLERANCE_MM = 1e-3;

    private final Surface surface;
    private final int index;
    private final Optional<NoGoZone> noGo;
    private final TriangleTree tree;
    private final double[] positions;
    private final double[] restBox;
    private final double[] box;
    private float[] pose = new float[0];

    MovingStructure(Surface surface, int index) {
        this.surface = surface;
        this.index = index;
        noGo = NoGoZone.of(surface.kind());
        tree = new TriangleTree(surface.rest());
        positions = surface.motion() == Surface.Motion.DEFORMING
                ? surface.rest().positions().clone()
                : surface.rest().positions();
        restBox = surface.rest().bounds();
        box = restBox.clone();
    }

    /** Moves the surface to a frame. */
    public void update(Frame frame) {
        if (surface.motion() == Surface.Motion.DEFORMING) {
            frame.writePositions(surface, index, positions);
            tree.refit(positions);
            System.arraycopy(surface.rest().withPositions(positions).bounds(), 0, box, 0, box.length);
        } else if (surface.motion() == Surface.Motion.RIGID) {
            pose = frame.pose(index).clone();
            updateRigidBox();
        }
    }

    /** Bounds of the transformed rest box: per axis, the extreme of each term. */
    private void updateRigidBox() {
        for (int row = 0; row < 3; row++) {
            double low = pose[4 * row + 3];
            double high = low;
            for (int axis = 0; axis < 3; axis++) {
                double a = pose[4 * row + axis] * restBox[axis];
                double b = pose[4 * row + axis] * restBox[3 + axis];
                low += Math.min(a, b);
                high += Math.max(a, b);
            }
            box[row] = low;
            box[3 + row] = high;
        }
    }

    /** Lower bound of the distance from a path, mm: the largest gap between their bounding boxes along an axis. */
    public double boxDistance(double[] from, double[] to) {
        double gap = 0;
        for (int axis = 0; axis < 3; axis++) {
            gap = Math.max(gap, box[axis] - Math.max(from[axis], to[axis]));
            gap = Math.max(gap, Math.min(from[axis], to[axis]) - box[3 + axis]);
        }
        return gap - BOX_TOLERANCE_MM;
    }

    /** The surface. */
    public Surface surface() {
        return surface;
    }

    /** Its no-go zone; empty if a needle may pass it. */
    public Optional<NoGoZone> noGo() {
        return noGo;
    }

    /** Display name: "right rib 8", "left lung", "liver". */
    public String label() {
        String side =
                surface.side() == Side.MIDLINE ? "" : surface.side().name().toLowerCase(Locale.ROOT) + " ";
        return switch (surface.kind()) {
            case RIB -> side + "rib " + surface.level();
            case COSTAL_CARTILAGE -> side + "costal cartilage " + surface.level();
            case LUNG -> side + "lung";
            case LIVER -> "liver";
            case DIAPHRAGM -> "diaphragm";
            case SKIN -> "skin";
            case STERNUM, VERTEBRA, DISC, OTHER -> surface.name().replace('_', ' ');
        };
    }

    /** The tree of the surface, in its local axes. */
    public TriangleTree tree() {
        return tree;
    }

    /** Vertex positions in local axes: of the frame for a deforming surface, at rest for a rigid one. */
    public double[] positions() {
        return positions;
    }

    /** Sets a probe to a path, in local axes. */
    public void setProbe(double[] from, double[] to, SegmentProbe probe) {
        double[] a = toLocal(from);
        double[] b = toLocal(to);
        probe.set(a[0], a[1], a[2], b[0], b[1], b[2]);
    }

    /** A point in local axes: x = R^T (x' - t). */
    public double[] toLocal(double[] world) {
        if (pose.length == 0) {
            return world.clone();
        }
        double[] local = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            for (int row = 0; row < 3; row++) {
                local[axis] += pose[4 * row + axis] * (world[row] - pose[4 * row + 3]);
            }
        }
        return local;
    }

    /** A point of the local axes in world axes. */
    public double[] toWorld(double[] local) {
        double[] world = local.clone();
        if (pose.length > 0) {
            Frame.transform(pose, local, world);
        }
        return world;
    }
}
