package org.phrenic.access;

import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * A moving surface that supports distance and intersection queries. For a deforming surface, the bounding volume tree
 * is refitted in a frame when it is first asked for: most structures are far from the needle. For a rigid surface, the
 * query is transformed into the rest axes of the surface instead.
 */
public final class MovingStructure {
    /** Tolerance for rounding errors when a box is transformed by a single precision pose, mm. */
    private static final double BOX_TOLERANCE_MM = 1e-3;

    private final Surface surface;
    private final int index;
    private final Optional<NoGoZone> noGo;
    private final TriangleTree tree;
    private final double[] positions;
    private final double[] restBox;
    private final double[] box;
    private float[] pose = new float[0];
    /** Whether the surface has moved since the tree was refitted. */
    private volatile boolean moved;

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

    /** Moves the surface to its position in a frame. */
    public void update(Frame frame) {
        if (surface.motion() == Surface.Motion.DEFORMING) {
            frame.writePositions(surface, index, positions);
            BoundingBoxes.around(positions, 0, positions.length, box, 0);
            moved = true;
        } else if (surface.motion() == Surface.Motion.RIGID) {
            pose = frame.pose(index).clone();
            updateRigidBox();
        }
    }

    /** Computes the bounding box of the transformed rest box. Each bound sums the extreme of each term. */
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

    /** Lower bound of the distance to a path, mm: the largest gap between the bounding boxes along an axis. */
    public double boxDistance(double[] from, double[] to) {
        double gap = 0;
        for (int axis = 0; axis < 3; axis++) {
            gap = Math.max(gap, box[axis] - Math.max(from[axis], to[axis]));
            gap = Math.max(gap, Math.min(from[axis], to[axis]) - box[3 + axis]);
        }
        return gap - BOX_TOLERANCE_MM;
    }

    public Surface surface() {
        return surface;
    }

    /** The no-go zone of the structure, or empty if a needle may pass through it. */
    public Optional<NoGoZone> noGo() {
        return noGo;
    }

    public String label() {
        return label(surface);
    }

    /** Display name of a structure, such as "right rib 8", "left lung" or "liver". */
    public static String label(Surface surface) {
        String side =
                surface.side() == Side.MIDLINE ? "" : surface.side().name().toLowerCase(Locale.ROOT) + " ";
        return switch (surface.kind()) {
            case RIB -> side + "rib " + surface.level();
            case COSTAL_CARTILAGE -> side + "costal cartilage " + surface.level();
            case LUNG -> side + "lung";
            case PLEURA -> side + "pleura";
            case LIVER -> "liver";
            case DIAPHRAGM -> "diaphragm";
            case SKIN -> "skin";
            case STERNUM, VERTEBRA, DISC -> surface.name().replace('_', ' ');
            case ORGAN, VESSEL, MUSCLE, BONE, LESION, OTHER -> side + OrganNames.words(surface.name());
        };
    }

    /** Bounding box in world axes, low corner and high corner, mm. */
    public double[] box() {
        return box.clone();
    }

    /** The surface in local axes. The first call after an update refits the tree, and other threads wait for it. */
    public TriangleTree tree() {
        if (moved) {
            refit();
        }
        return tree;
    }

    private synchronized void refit() {
        if (moved) {
            tree.refit(positions);
            moved = false;
        }
    }

    /** Vertex positions in local axes: current positions of a deforming surface, rest positions of a rigid one. */
    public double[] positions() {
        return positions;
    }

    /** Sets a probe to a path, converted to local axes. */
    public void setProbe(double[] from, double[] to, SegmentProbe probe) {
        double[] a = toLocal(from);
        double[] b = toLocal(to);
        probe.set(a[0], a[1], a[2], b[0], b[1], b[2]);
    }

    /** Converts a point from world to local axes: x = R^T (x' - t). */
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

    /** Converts a point from local to world axes. */
    public double[] toWorld(double[] local) {
        double[] world = local.clone();
        if (pose.length > 0) {
            Frame.transform(pose, local, world);
        }
        return world;
    }
}
