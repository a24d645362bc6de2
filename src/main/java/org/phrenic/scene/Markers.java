package org.phrenic.scene;

import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.geometry.Vectors;
import org.phrenic.simulation.Surface;

/** Things that are no part of a body, as surfaces that stand still: a ball, a rod. */
final class Markers {
    private static final int AROUND = 24;

    private Markers() {}

    /** Markers that move rest out here, where nothing shades them. */
    private static final double[] AWAY = {0, 0, -5000};

    /** What names of markers that move begin with. */
    static final String MOVING = "marker_";

    /** Whether a surface is a marker that moves. */
    static boolean moves(String name) {
        return name.startsWith(MOVING);
    }

    /** A ball of radius 1 that {@link #ballAt} puts somewhere. */
    static Surface movingBall(String name) {
        return ball(name, AWAY, 1);
    }

    /** A rod of length and radius 1 that {@link #rodAt} puts somewhere. */
    static Surface movingRod(String name) {
        return rod(name, AWAY, new double[] {AWAY[0], AWAY[1], AWAY[2] + 1}, 1);
    }

    /** Pose of a moving ball, three rows of four. */
    static float[] ballAt(double[] middle, double radius) {
        return pose(new double[][] {{radius, 0, 0}, {0, radius, 0}, {0, 0, radius}}, middle);
    }

    /** Pose of a moving rod, three rows of four. */
    static float[] rodAt(double[] from, double[] to, double radius) {
        double[] along = Vectors.minus(to, from);
        double[] w = Vectors.unit(along);
        double[] u = across(w);
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
            pose[4 * row + 3] = (float) (at[row] - Vectors.dot(m[row], AWAY));
        }
        return pose;
    }

    /** A ball. */
    static Surface ball(String name, double[] middle, double radius) {
        int rings = AROUND / 2;
        double[] profile = new double[2 * (rings - 1)];
        for (int i = 1; i < rings; i++) {
            profile[2 * i - 2] = -radius * StrictMath.cos(Math.PI * i / rings);
            profile[2 * i - 1] = radius * StrictMath.sin(Math.PI * i / rings);
        }
        double[] axis = {0, 0, 1};
        return surface(name, turned(middle, axis, -radius, radius, profile));
    }

    /** A round rod between two points. */
    static Surface rod(String name, double[] from, double[] to, double radius) {
        double[] axis = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        for (int i = 0; i < 3; i++) {
            axis[i] /= length;
        }
        return surface(name, turned(from, axis, 0, length, new double[] {0, radius, length, radius}));
    }

    private static Surface surface(String name, TriangleMesh mesh) {
        return new Surface(name, StructureKind.OTHER, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    /** A profile of pairs (along the axis, away from it) turned about the axis and closed at both ends. */
    private static TriangleMesh turned(double[] origin, double[] axis, double start, double end, double[] profile) {
        double[] u = across(axis);
        double[] v = {axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2], axis[0] * u[1] - axis[1] * u[0]
        };
        int rings = profile.length / 2;
        double[] p = new double[3 * (rings * AROUND + 2)];
        for (int r = 0; r < rings; r++) {
            for (int k = 0; k < AROUND; k++) {
                double c = profile[2 * r + 1] * StrictMath.cos(2 * Math.PI * k / AROUND);
                double s = profile[2 * r + 1] * StrictMath.sin(2 * Math.PI * k / AROUND);
                for (int i = 0; i < 3; i++) {
                    p[3 * (r * AROUND + k) + i] = origin[i] + profile[2 * r] * axis[i] + c * u[i] + s * v[i];
                }
            }
        }
        int bottom = rings * AROUND;
        for (int i = 0; i < 3; i++) {
            p[3 * bottom + i] = origin[i] + start * axis[i];
            p[3 * bottom + 3 + i] = origin[i] + end * axis[i];
        }
        int[] t = new int[6 * rings * AROUND];
        int n = 0;
        for (int k = 0; k < AROUND; k++) {
            int next = (k + 1) % AROUND;
            int top = (rings - 1) * AROUND;
            n = put(t, n, bottom, next, k);
            n = put(t, n, bottom + 1, top + k, top + next);
            for (int r = 0; r + 1 < rings; r++) {
                n = put(t, n, r * AROUND + k, r * AROUND + next, (r + 1) * AROUND + next);
                n = put(t, n, r * AROUND + k, (r + 1) * AROUND + next, (r + 1) * AROUND + k);
            }
        }
        return new TriangleMesh(p, t);
    }

    private static int put(int[] t, int at, int a, int b, int c) {
        t[at] = a;
        t[at + 1] = b;
        t[at + 2] = c;
        return at + 3;
    }

    /** A unit direction at a right angle. */
    private static double[] across(double[] axis) {
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
