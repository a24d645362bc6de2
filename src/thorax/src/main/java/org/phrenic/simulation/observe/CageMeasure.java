package org.phrenic.simulation.observe;

import java.util.Arrays;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.engine.kinematics.HelicalBody;
import org.phrenic.mesh.TriangleMesh;

/** Diameters of the rib cage and motion of the sternum, along the axes of the body's frame. */
public final class CageMeasure {
    private static final int[] WIDE_LEVELS = {5, 6, 7, 8, 9, 10};

    private final RibCagePose pose;
    /** Axes of the body's frame, three numbers each. */
    private final double[] axes;

    private final double[][] right = new double[WIDE_LEVELS.length][];
    private final double[][] left = new double[WIDE_LEVELS.length][];
    private final double[] sternumPoint;
    private final double restWidth;
    private double[] scratch = new double[0];

    public CageMeasure(Thorax thorax, RibCagePose pose) {
        this.pose = pose;
        axes = pose.cage().frame().axes();
        for (int i = 0; i < WIDE_LEVELS.length; i++) {
            right[i] = points(thorax, WIDE_LEVELS[i], Side.RIGHT);
            left[i] = points(thorax, WIDE_LEVELS[i], Side.LEFT);
            scratch = new double[Math.max(scratch.length, Math.max(right[i].length, left[i].length))];
        }
        sternumPoint = sternumPoint(thorax, pose.cage().frame());
        restWidth = width(true);
    }

    /** Whether a body has ribs of one level on both sides, between which the transverse diameter is measured. */
    static boolean hasWidth(Thorax thorax) {
        return Arrays.stream(WIDE_LEVELS)
                .anyMatch(level ->
                        points(thorax, level, Side.RIGHT).length > 0 && points(thorax, level, Side.LEFT).length > 0);
    }

    private static double[] points(Thorax thorax, int level, Side side) {
        return thorax.find(StructureKind.RIB, level, side)
                .map(s -> s.mesh().positions())
                .orElse(new double[0]);
    }

    /** Centre of the lower end of the sternal body; null without a sternum. */
    private static double[] sternumPoint(Thorax thorax, MedianFrame frame) {
        Structure body = thorax.find("sternum_body")
                .orElse(thorax.structuresOf(StructureKind.STERNUM).stream()
                        .findFirst()
                        .orElse(null));
        if (body == null) {
            return null;
        }
        TriangleMesh upright = frame.toFrame(body.mesh());
        double[] box = upright.bounds();
        double limit = box[2] + 0.2 * (box[5] - box[2]);
        double[] sum = new double[3];
        int count = 0;
        for (int i = 0; i < body.mesh().vertexCount(); i++) {
            if (upright.z(i) <= limit) {
                sum[0] += body.mesh().x(i);
                sum[1] += body.mesh().y(i);
                sum[2] += body.mesh().z(i);
                count++;
            }
        }
        return new double[] {sum[0] / count, sum[1] / count, sum[2] / count};
    }

    /** Largest transverse distance between ribs of the same level, at rest or in the current pose, mm. */
    private double width(boolean rest) {
        double widest = 0;
        for (int i = 0; i < WIDE_LEVELS.length; i++) {
            if (right[i].length > 0 && left[i].length > 0) {
                double toLeft = extreme(left[i], WIDE_LEVELS[i], Side.LEFT, rest);
                double toRight = extreme(right[i], WIDE_LEVELS[i], Side.RIGHT, rest);
                widest = Math.max(widest, toLeft + toRight);
            }
        }
        return widest;
    }

    /** Lateral extreme of a rib on its side, mm. */
    private double extreme(double[] points, int level, Side side, boolean rest) {
        double[] p = points;
        if (!rest) {
            int body = pose.cage().rib(level, side);
            HelicalBody.transformPoints(pose.pose(body), points, 0, scratch, 0, points.length / 3);
            p = scratch;
        }
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < points.length; i += 3) {
            most = Math.max(most, side.sign() * MedianFrame.along(axes, 0, p[i], p[i + 1], p[i + 2]));
        }
        return most;
    }

    /** Increase of the transverse diameter from rest, mm. */
    public double transverseChange() {
        return width(false) - restWidth;
    }

    /** Displacement of the lower end of the sternal body from rest: left, posterior, superior, mm. */
    public double[] sternumMotion() {
        if (sternumPoint == null || pose.cage().sternum() == RibCage.TRUNK) {
            return new double[3];
        }
        double[] moved = new double[3];
        HelicalBody.transformPoints(pose.pose(pose.cage().sternum()), sternumPoint, 0, moved, 0, 1);
        for (int axis = 0; axis < 3; axis++) {
            moved[axis] -= sternumPoint[axis];
        }
        return new double[] {
            MedianFrame.along(axes, 0, moved[0], moved[1], moved[2]),
            MedianFrame.along(axes, 1, moved[0], moved[1], moved[2]),
            MedianFrame.along(axes, 2, moved[0], moved[1], moved[2])
        };
    }
}
