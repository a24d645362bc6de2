package org.phrenic.engine.kinematics;

/**
 * A rigid body that moves along its helical axis with one amplitude {@code s}: 0 at rest (end-expiration), 1 at the
 * full rotation and slide of the axis (full inspiration), negative beyond rest.
 *
 * <p>{@code x(s) = p + Rot(d, s theta) (x0 - p) + s slide d}. The axis is fixed, so the velocity is that of a screw for
 * every {@code s}: {@code v(x) = w x x + v0} with {@code w = theta ds/dt d} and {@code v0 = slide ds/dt d - w x p}.
 * Prescribed nodes therefore get exact velocities without finite differences.
 *
 * @param axis axis of the full motion
 */
public record HelicalBody(HelicalAxis axis) {
    /** Length of a pose array: three rows of {@code [R | t]}. */
    public static final int POSE_LENGTH = 12;

    /** Length of a twist array: {@code w} in rad/s, then {@code v0} in mm/s, the velocity of the body at the origin. */
    public static final int TWIST_LENGTH = 6;

    /**
     * Computes the pose of the body at an amplitude.
     *
     * @param amplitude s, dimensionless
     * @param pose receives {@value #POSE_LENGTH} numbers, row by row {@code [R | t]}, t in mm
     */
    public void pose(double amplitude, double[] pose) {
        double dx = axis.directionX();
        double dy = axis.directionY();
        double dz = axis.directionZ();
        double turn = amplitude * axis.angle();
        double sine = StrictMath.sin(turn);
        double half = StrictMath.sin(0.5 * turn);
        // Rodrigues' formula R = I + sine K + versine K^2 with the cross-product matrix K of the direction. The
        // versine,
        // 1 - cos, is without cancellation at small angles; s = 0 gives an exact identity.
        double versine = 2 * half * half;
        double shift = amplitude * axis.slide();
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
        double spin = rate * axis.angle();
        double shift = rate * axis.slide();
        twist[0] = spin * axis.directionX();
        twist[1] = spin * axis.directionY();
        twist[2] = spin * axis.directionZ();
        twist[3] = shift * axis.directionX() - (twist[1] * axis.pointZ() - twist[2] * axis.pointY());
        twist[4] = shift * axis.directionY() - (twist[2] * axis.pointX() - twist[0] * axis.pointZ());
        twist[5] = shift * axis.directionZ() - (twist[0] * axis.pointY() - twist[1] * axis.pointX());
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

    /** Writes a row of {@code R - I} and of the translation {@code -(R - I) p} that keeps the axis fixed. */
    private void row(double[] pose, int at, double x, double y, double z) {
        pose[at] = x;
        pose[at + 1] = y;
        pose[at + 2] = z;
        pose[at + 3] = -(x * axis.pointX() + y * axis.pointY() + z * axis.pointZ());
    }
}
