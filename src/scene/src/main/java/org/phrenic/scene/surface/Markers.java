package org.phrenic.scene.surface;

import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Surface;

/** Things that are no part of a body, as surfaces that stand still: a ball, a rod. */
public final class Markers {
    private static final int SEGMENTS = 24;

    private Markers() {}

    /** Markers that move rest out here, where nothing shades them. */
    private static final double[] PARKED = {0, 0, -5000};

    /** What names of markers that move begin with. */
    public static final String PREFIX = "marker_";

    /** Whether a surface is a marker that moves. */
    public static boolean isMovable(String name) {
        return name.startsWith(PREFIX);
    }

    /** A ball of radius 1 that {@link #ballPose} puts somewhere. */
    public static Surface movingBall(String name) {
        return ball(name, PARKED, 1);
    }

    /** A rod of length and radius 1 that {@link #rodPose} puts somewhere. */
    public static Surface movingRod(String name) {
        return rod(name, PARKED, new double[] {PARKED[0], PARKED[1], PARKED[2] + 1}, 1);
    }

    /** Pose of a moving ball, three rows of four. */
    public static float[] ballPose(double[] middle, double radius) {
        return pose(new double[][] {{radius, 0, 0}, {0, radius, 0}, {0, 0, radius}}, middle);
    }

    /** Pose of a moving rod, three rows of four. */
    public static float[] rodPose(double[] from, double[] to, double radius) {
        double[] along = Vectors.subtract(to, from);
        double[] w = Vectors.normalize(along);
        double[] u = perpendicular(w);
        double[] v = Vectors.cross(w, u);
        return pose(
                new double[][] {
                    {radius * u[0], radius * v[0], along[0]},
                    {radius * u[1], radius * v[1], along[1]},
                    {radius * u[2], radius * v[2], along[2]}
                },
                from);
    }

    private static float[] pose(double[][] m, double[] at) {
        float[] pose = new float[12];
        for (int row = 0; row < 3; row++) {
            for (int k = 0; k < 3; k++) {
                pose[4 * row + k] = (float) m[row][k];
            }
            pose[4 * row + 3] = (float) (at[row] - Vectors.dot(m[row], PARKED));
        }
        return pose;
    }

    /** A ball. */
    public static Surface ball(String name, double[] middle, double radius) {
        int rings = SEGMENTS / 2;
        double[] profile = new double[2 * (rings - 1)];
        for (int i = 1; i < rings; i++) {
            profile[2 * i - 2] = -radius * StrictMath.cos(Math.PI * i / rings);
            profile[2 * i - 1] = radius * StrictMath.sin(Math.PI * i / rings);
        }
        double[] axis = {0, 0, 1};
        return surface(name, surfaceOfRevolution(middle, axis, -radius, radius, profile));
    }

    /** A round rod between two points. */
    public static Surface rod(String name, double[] from, double[] to, double radius) {
        double[] axis = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        for (int i = 0; i < 3; i++) {
            axis[i] /= length;
        }
        return surface(name, surfaceOfRevolution(from, axis, 0, length, new double[] {0, radius, length, radius}));
    }

    private static Surface surface(String name, TriangleMesh mesh) {
        return new Surface(name, StructureKind.OTHER, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    /** A profile of pairs (along the axis, away from it) turned about the axis and closed at both ends. */
    private static TriangleMesh surfaceOfRevolution(
            double[] origin, double[] axis, double start, double end, double[] profile) {
        double[] u = perpendicular(axis);
        double[] v = {axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2], axis[0] * u[1] - axis[1] * u[0]
        };
        int rings = profile.length / 2;
        double[] p = new double[3 * (rings * SEGMENTS + 2)];
        for (int r = 0; r < rings; r++) {
            for (int k = 0; k < SEGMENTS; k++) {
                double c = profile[2 * r + 1] * StrictMath.cos(2 * Math.PI * k / SEGMENTS);
                double s = profile[2 * r + 1] * StrictMath.sin(2 * Math.PI * k / SEGMENTS);
                for (int i = 0; i < 3; i++) {
                    p[3 * (r * SEGMENTS + k) + i] = origin[i] + profile[2 * r] * axis[i] + c * u[i] + s * v[i];
                }
            }
        }
        int bottom = rings * SEGMENTS;
        for (int i = 0; i < 3; i++) {
            p[3 * bottom + i] = origin[i] + start * axis[i];
            p[3 * bottom + 3 + i] = origin[i] + end * axis[i];
        }
        int[] t = new int[6 * rings * SEGMENTS];
        int n = 0;
        for (int k = 0; k < SEGMENTS; k++) {
            int next = (k + 1) % SEGMENTS;
            int top = (rings - 1) * SEGMENTS;
            n = putTriangle(t, n, bottom, next, k);
            n = putTriangle(t, n, bottom + 1, top + k, top + next);
            for (int r = 0; r + 1 < rings; r++) {
                n = putTriangle(t, n, r * SEGMENTS + k, r * SEGMENTS + next, (r + 1) * SEGMENTS + next);
                n = putTriangle(t, n, r * SEGMENTS + k, (r + 1) * SEGMENTS + next, (r + 1) * SEGMENTS + k);
            }
        }
        return new TriangleMesh(p, t);
    }

    private static int putTriangle(int[] t, int at, int a, int b, int c) {
        t[at] = a;
        t[at + 1] = b;
        t[at + 2] = c;
        return at + 3;
    }

    /** A unit direction at a right angle. */
    private static double[] perpendicular(double[] axis) {
        double[] u = Math.abs(axis[0]) < 0.8 ? new double[] {1, 0, 0} : new double[] {0, 1, 0};
        double along = u[0] * axis[0] + u[1] * axis[1] + u[2] * axis[2];
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            u[i] -= along * axis[i];
            sum += u[i] * u[i];
        }
        for (int i = 0; i < 3; i++) {
            u[i] /= Math.sqrt(sum);
        }
        return u;
    }
}
