package org.phrenic.anatomy;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * The frame of a body whose median plane is the plane x = const. A patient lies turned on the table or bent to a side;
 * what is defined along the axes of LPS (the axes of the ribs, the leaflets of the tendon, right and left of a sheet)
 * is computed in this frame and brought back. The plane is normal to the mean vector from right ribs to left ones of
 * the same level.
 */
public final class MedianFrame {
    /**
     * Angle up to which a body counts as straight, degrees: people are not quite symmetric. Seven scans have up to 2.4.
     */
    private static final double STRAIGHT_DEG = 3;

    private static final int RIBS = 12;
    private static final MedianFrame STRAIGHT = new MedianFrame(Optional.empty());

    private final Optional<RigidMotion> toFrame;

    private MedianFrame(Optional<RigidMotion> toFrame) {
        this.toFrame = toFrame;
    }

    /** The frame of a straight body, whose axes are those of LPS. */
    public static MedianFrame straight() {
        return STRAIGHT;
    }

    /** The frame of a body in LPS, mm; that of the body itself if it lies straight or has no pair of ribs. */
    public static MedianFrame of(Thorax body) {
        double[] left = new double[3];
        double[] middle = new double[3];
        int pairs = 0;
        for (int level = 1; level <= RIBS; level++) {
            Optional<double[]> r =
                    body.find(StructureKind.RIB, level, Side.RIGHT).map(s -> centre(s.mesh()));
            Optional<double[]> l =
                    body.find(StructureKind.RIB, level, Side.LEFT).map(s -> centre(s.mesh()));
            for (int axis = 0; axis < 3 && r.isPresent() && l.isPresent(); axis++) {
                left[axis] += l.get()[axis] - r.get()[axis];
                middle[axis] += 0.5 * (l.get()[axis] + r.get()[axis]);
            }
            pairs += r.isPresent() && l.isPresent() ? 1 : 0;
        }
        double length = Vectors.length(left);
        if (pairs == 0 || !(left[0] > 0)) {
            return STRAIGHT;
        }
        double[] n = {left[0] / length, left[1] / length, left[2] / length};
        if (n[0] > StrictMath.cos(Math.toRadians(STRAIGHT_DEG))) {
            return STRAIGHT;
        }
        // The least rotation that brings n to the x axis.
        double f = 1 / (1 + n[0]);
        double[] rotation = {
            n[0], n[1], n[2], -n[1], 1 - f * n[1] * n[1], -f * n[1] * n[2], -n[2], -f * n[1] * n[2], 1 - f * n[2] * n[2]
        };
        double[] c = {middle[0] / pairs, middle[1] / pairs, middle[2] / pairs};
        double[] shift = new double[3];
        for (int row = 0; row < 3; row++) {
            shift[row] =
                    c[row] - rotation[3 * row] * c[0] - rotation[3 * row + 1] * c[1] - rotation[3 * row + 2] * c[2];
        }
        return new MedianFrame(Optional.of(RigidMotion.of(rotation, shift)));
    }

    private static double[] centre(TriangleMesh mesh) {
        double[] p = mesh.positions();
        double[] centre = new double[3];
        for (int i = 0; i < p.length; i++) {
            centre[i % 3] += p[i] / mesh.vertexCount();
        }
        return centre;
    }

    /** Whether the axes of this frame are those of LPS. */
    public boolean isStraight() {
        return toFrame.isEmpty();
    }

    /** The body in this frame. */
    public Thorax toFrame(Thorax body) {
        return isStraight()
                ? body
                : new Thorax(
                        body.name(),
                        body.structures().stream().map(this::toFrame).toList(),
                        body.notes(),
                        body.notInScan(),
                        body.organs());
    }

    /** The structure in this frame. */
    public Structure toFrame(Structure structure) {
        return isStraight() ? structure : structure.withMesh(toFrame(structure.mesh()));
    }

    /** A structure of this frame in the axes of the scan. */
    public Structure toScan(Structure structure) {
        return isStraight() ? structure : structure.withMesh(toScan(structure.mesh()));
    }

    /** The surface in this frame. */
    public TriangleMesh toFrame(TriangleMesh mesh) {
        return toFrame.map(motion -> moved(mesh, motion)).orElse(mesh);
    }

    /** A surface of this frame in the axes of the scan. */
    public TriangleMesh toScan(TriangleMesh mesh) {
        return toFrame.map(motion -> moved(mesh, motion.inverse())).orElse(mesh);
    }

    /** A helical axis in this frame. */
    public HelicalAxis toFrame(HelicalAxis axis) {
        return toFrame.map(axis::movedBy).orElse(axis);
    }

    /** A helical axis of this frame in the axes of the scan. */
    public HelicalAxis toScan(HelicalAxis axis) {
        return toFrame.map(motion -> axis.movedBy(motion.inverse())).orElse(axis);
    }

    /** The point in this frame, mm. */
    public double[] toFrame(double[] point) {
        return toFrame.map(motion -> motion.apply(point[0], point[1], point[2])).orElse(point);
    }

    /** A point of this frame in the axes of the scan, mm. */
    public double[] toScan(double[] point) {
        return toFrame.map(motion -> motion.inverse().apply(point[0], point[1], point[2]))
                .orElse(point);
    }

    /**
     * Unit vectors of the axes of this frame (left, posterior, superior) in the axes of the scan, one after another.
     */
    public double[] axes() {
        RigidMotion motion = toFrame.orElse(RigidMotion.identity());
        double[] axes = new double[9];
        Arrays.setAll(axes, i -> motion.rotation(i / 3, i % 3));
        return axes;
    }

    /** Component of a vector of the scan along an axis of a frame, of which {@link #axes} gives all three. */
    public static double along(double[] axes, int axis, double x, double y, double z) {
        return axes[3 * axis] * x + axes[3 * axis + 1] * y + axes[3 * axis + 2] * z;
    }

    private static TriangleMesh moved(TriangleMesh mesh, RigidMotion motion) {
        double[] p = mesh.positions().clone();
        motion.apply(p);
        return mesh.withPositions(p);
    }
}
