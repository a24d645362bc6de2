package org.phrenic.engine.kinematics;

/**
 * A rigid body that moves along its helical axis with one amplitude {@code s}: 0 at rest (end-expiration), 1 at the
 * full rotation and slide of the axis (full inspiration), negative beyond rest.
 *
 * <p>{@code x(s) = p + Rot(d, s theta) (x0 - p) + s slide d}. The axis is fixed, so the velocity is that of a screw for
 * every {@code s}: {@code v(x) = w x x + v0} with {@code w = theta ds/dt d} and {@code v0 = slide ds/dt d - w x p}.
 * Prescribed nodes therefore get exact velocities without finite differences.
 */
public final class HelicalBody {
    /** Length of a pose array: three rows of {@code [R | t]}. */
    public static final int POSE_LENGTH = 12;

    /** Length of a twist array: {@code w} in rad/s, then {@code v0} in mm/s, the velocity of the body at the origin. */
    public static final int TWIST_LENGTH = 6;

    private final double dx;
    private final double dy;
    private final double dz;
    private final double px;
    private final double py;
    private final double pz;
    private final double angle;
    private final double slide;

    /** Creates a body at rest with the axis of its full motion. */
    public HelicalBody(HelicalAxis axis) {
        dx = axis.directionX();
        dy = axis.directionY();
        dz = axis.directionZ();
        px = axis.pointX();
        py = axis.pointY();
        pz = axis.pointZ();
        angle = axis.angle();
        slide = axis.slide();
    }

    /**
     * Computes the pose of the body at an amplitude.
     *
     * @param amplitude s, dimensionless
     * @param pose receives {@value #POSE_LENGTH} numbers, row by row {@code [R | t]}, t in mm
     */
    public void pose(double amplitude, double[] pose) {
        double turn = amplitude * angle;
        double sine = StrictMath.sin(turn);
        double half = StrictMath.sin(0.5 * turn);
        // 1 - cos without cancellation at small angles; s = 0 gives an exact identity.
        double versine = 2 * half * half;
        double shift = amplitude * slide;
        row(pose, 0, -versine * (dy * dy + dz * dz), versine * dx * dy - sine * dz, versine * dx * dz + sine * dy);
        row(pose, 4, versine * dx * dy + sine * dz, -versine * (dx * dx + dz * dz), versine * dy * dz - sine * dx);
        row(pose, 8, versine * dx * dz - sine * dy, versine * dy * dz + sine * dx, -versine * (dx * dx + dy * dy));
        pose[0] += 1;
        pose[5] += 1;
        pose[10] += 1;
        pose[3] += shift * dx;
        pose[7] += shift * dy;
        pose[11] += shift * dz;
    }

    /**
     * Computes the twist of the body.
     *
     * @param rate ds/dt, 1/s
     * @param twist receives {@value #TWIST_LENGTH} numbers
     */
    public void twist(double rate, double[] twist) {
        double spin = rate * angle;
        twist[0] = spin * dx;
        twist[1] = spin * dy;
        twist[2] = spin * dz;
        twist[3] = rate * slide * dx - (twist[1] * pz - twist[2] * py);
        twist[4] = rate * slide * dy - (twist[2] * px - twist[0] * pz);
        twist[5] = rate * slide * dz - (twist[0] * py - twist[1] * px);
    }

    /**
     * Transforms points of the body.
     *
     * @param pose pose of the body
     * @param rest x, y, z of points at rest, mm
     * @param from first point to read
     * @param moved receives the transformed points, mm; must not be {@code rest}
     * @param to first point to write
     * @param count number of points
     */
    public static void transformPoints(double[] pose, double[] rest, int from, double[] moved, int to, int count) {
        int i = 3 * from;
        int o = 3 * to;
        for (int n = 0; n < count; n++, i += 3, o += 3) {
            double x = rest[i];
            double y = rest[i + 1];
            double z = rest[i + 2];
            moved[o] = pose[0] * x + pose[1] * y + pose[2] * z + pose[3];
            moved[o + 1] = pose[4] * x + pose[5] * y + pose[6] * z + pose[7];
            moved[o + 2] = pose[8] * x + pose[9] * y + pose[10] * z + pose[11];
        }
    }

    /**
     * Computes velocities of points of the body.
     *
     * @param twist twist of the body
     * @param moved current x, y, z of points, mm
     * @param from first point to read
     * @param velocities receives the velocities, mm/s
     * @param to first point to write
     * @param count number of points
     */
    public static void pointVelocities(
            double[] twist, double[] moved, int from, double[] velocities, int to, int count) {
        int i = 3 * from;
        int o = 3 * to;
        for (int n = 0; n < count; n++, i += 3, o += 3) {
            double x = moved[i];
            double y = moved[i + 1];
            double z = moved[i + 2];
            velocities[o] = twist[1] * z - twist[2] * y + twist[3];
            velocities[o + 1] = twist[2] * x - twist[0] * z + twist[4];
            velocities[o + 2] = twist[0] * y - twist[1] * x + twist[5];
        }
    }

    /** Writes a row of {@code R - I} and of the translation {@code -(R - I) p} that keeps the axis fixed. */
    private void row(double[] pose, int at, double x, double y, double z) {
        pose[at] = x;
        pose[at + 1] = y;
        pose[at + 2] = z;
        pose[at + 3] = -(x * px + y * py + z * pz);
    }
}
