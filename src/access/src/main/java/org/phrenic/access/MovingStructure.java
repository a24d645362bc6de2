package org.phrenic.access;

import java.util.Optional;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * One surface of a scene as it moves: the tree of what deforms is refitted to each frame; for what is rigid the path is
 * moved into its axes instead.
 */
public final class MovingStructure {
    /** A pose is a float: a turned box may lie off by so much. */
    private static final double BOX_SLACK_MM = 1e-3;

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

    /** Takes over where it is. */
    public void update(Frame frame) {
        switch (surface.motion()) {
            case DEFORMING -> {
                frame.writePositions(surface, index, positions);
                tree.refit(positions);
                System.arraycopy(surface.rest().withPositions(positions).bounds(), 0, box, 0, box.length);
            }
            case RIGID -> {
                pose = frame.pose(index).clone();
                updateRigidBox();
            }
            case STILL -> {
                // Where it always is.
            }
        }
    }

    /** The box about the turned box: each axis gathers the ends of the rest box that lie farther along it. */
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

    /**
     * No more than the distance between a path and the surface: that between their boxes along the axis on which they
     * are farthest apart, mm.
     */
    public double boxDistance(double[] from, double[] to) {
        double gap = 0;
        for (int axis = 0; axis < 3; axis++) {
            gap = Math.max(gap, box[axis] - Math.max(from[axis], to[axis]));
            gap = Math.max(gap, Math.min(from[axis], to[axis]) - box[3 + axis]);
        }
        return gap - BOX_SLACK_MM;
    }

    /** The surface. */
    public Surface surface() {
        return surface;
    }

    /** What it is to a needle; empty for what a needle passes on its way. */
    public Optional<NoGoZone> noGo() {
        return noGo;
    }

    /** Its name for people: "right rib 8". */
    public String label() {
        return StructureLabel.of(surface);
    }

    public TriangleTree tree() {
        return tree;
    }

    /** Where the vertices of what deforms are; of a rigid body where they rest. */
    public double[] positions() {
        return positions;
    }

    /** Lays a path into a probe, in the axes in which {@link #tree} holds the surface. */
    public void setProbe(double[] from, double[] to, SegmentProbe probe) {
        if (pose.length == 0) {
            probe.set(from[0], from[1], from[2], to[0], to[1], to[2]);
        } else {
            probe.set(
                    toLocal(0, from),
                    toLocal(1, from),
                    toLocal(2, from),
                    toLocal(0, to),
                    toLocal(1, to),
                    toLocal(2, to));
        }
    }

    /** Coordinate of a point in the axes of the tree: x = R^T (x' - t). */
    private double toLocal(int axis, double[] at) {
        double sum = 0;
        for (int row = 0; row < 3; row++) {
            sum += pose[4 * row + axis] * (at[row] - pose[4 * row + 3]);
        }
        return sum;
    }

    /** A point in the axes of the tree. */
    public double[] toLocal(double[] at) {
        return pose.length == 0 ? at.clone() : new double[] {toLocal(0, at), toLocal(1, at), toLocal(2, at)};
    }

    /** A point given in the axes of the tree. */
    public double[] toWorld(double[] own) {
        if (pose.length == 0) {
            return own.clone();
        }
        double[] at = new double[3];
        Frame.transform(pose, own, at);
        return at;
    }
}
