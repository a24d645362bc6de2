package org.phrenic.scene.surface;

import java.util.Arrays;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Matrix4f;
import org.joml.Vector3d;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.RingStack;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/** Spheres and cylinders that mark positions in a scene, as surfaces. */
public final class Markers {
    private static final int SEGMENTS = 24;
    /** Rest position of movable markers, outside the ambient occlusion grid. */
    private static final Matrix4d PARKED = new Matrix4d().translation(0, 0, -5000);
    /** Prefix of the names of movable markers. */
    public static final String PREFIX = "marker_";
    /** Unit sphere at the origin. */
    private static final TriangleMesh BALL = RingStack.unitBall(SEGMENTS);
    /** Cylinder of radius 1 along z from 0 to 1. */
    private static final TriangleMesh ROD = RingStack.revolution(SEGMENTS, 0, 1, 0, 1, 1, 1);

    private Markers() {}

    /** Whether a surface is a movable marker. */
    public static boolean isMovable(String name) {
        return name.startsWith(PREFIX);
    }

    /** A movable sphere, placed by {@link #ballPose}. */
    public static Surface movingBall(String name) {
        return surface(name, BALL, PARKED);
    }

    /** A movable cylinder, placed by {@link #rodPose}. */
    public static Surface movingRod(String name) {
        return surface(name, ROD, PARKED);
    }

    /** A movable surface of any shape, placed by {@link #shapePose}. */
    public static Surface movingShape(String name, TriangleMesh shape) {
        return surface(name, shape, PARKED);
    }

    /**
     * Pose of a movable surface as a row-major 3 x 4 matrix.
     *
     * @param origin where its origin goes
     * @param x unit vector of its first axis, {@code y} of its second, {@code z} of its third
     */
    public static float[] shapePose(double[] origin, double[] x, double[] y, double[] z) {
        return rows(new Matrix4d()
                .translation(new Vector3d(origin))
                .mul(new Matrix4d(new Matrix3d(new Vector3d(x), new Vector3d(y), new Vector3d(z)))));
    }

    /** Pose of a movable sphere as a row-major 3 x 4 matrix. */
    public static float[] ballPose(double[] centre, double radius) {
        return rows(ballTransform(centre, radius));
    }

    /** Pose of a movable cylinder as a row-major 3 x 4 matrix. */
    public static float[] rodPose(double[] from, double[] to, double radius) {
        return rows(rodTransform(from, to, radius));
    }

    private static float[] rows(Matrix4d transform) {
        Matrix4f fromParked = new Matrix4f(transform.mul(PARKED.invert(new Matrix4d())));
        return Arrays.copyOf(fromParked.transpose().get(new float[16]), 12);
    }

    public static Surface ball(String name, double[] centre, double radius) {
        return surface(name, BALL, ballTransform(centre, radius));
    }

    public static Surface rod(String name, double[] from, double[] to, double radius) {
        return surface(name, ROD, rodTransform(from, to, radius));
    }

    private static Matrix4d ballTransform(double[] centre, double radius) {
        return new Matrix4d().translation(new Vector3d(centre)).scale(radius);
    }

    private static Matrix4d rodTransform(double[] from, double[] to, double radius) {
        Vector3d w = new Vector3d(to).sub(new Vector3d(from));
        double length = w.length();
        w.normalize();
        Vector3d u = Math.abs(w.x) < 0.8 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
        u.fma(-u.dot(w), w).normalize();
        return new Matrix4d()
                .translation(new Vector3d(from))
                .mul(new Matrix4d(new Matrix3d(u, w.cross(u, new Vector3d()), w)))
                .scale(radius, radius, length);
    }

    private static Surface surface(String name, TriangleMesh unit, Matrix4d transform) {
        double[] p = unit.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            Vector3d at = transform.transformPosition(new Vector3d(p[i], p[i + 1], p[i + 2]));
            p[i] = at.x;
            p[i + 1] = at.y;
            p[i + 2] = at.z;
        }
        TriangleMesh placed = unit.withPositions(p);
        return new Surface(name, StructureKind.OTHER, 0, Side.MIDLINE, placed, Surface.Motion.STILL, new boolean[0]);
    }
}
