package org.phrenic.engine.kinematics;

/**
 * A rigid motion as a screw: a rotation by {@code angle} about an axis and a translation along it.
 *
 * <p>{@code x' = p + Rot(d, angle) (x - p) + slide d}. For a motion {@code x' = R x + v}, {@code theta} and {@code d}
 * follow from the quaternion of {@code R}, which is accurate for angles near 0 and near pi. Then {@code slide = d . v},
 * and {@code p = 1/2 [v - slide d + cot(theta/2) d x v]} is the point of the axis nearest to the origin (C. W. Spoor,
 * F. E. Veldpaus 1980, doi 10.1016/0021-9290(80)90020-2). Errors of direction and position grow as {@code 1 / (2
 * sin(theta/2))} (H. J. Woltring et al. 1985, J. Biomech. 18:379), so fit axes to full breaths, not to tidal ones.
 *
 * @param directionX unit direction, right-hand rule; exact to 9 digits at least, and made exact to all
 * @param directionY unit direction
 * @param directionZ unit direction
 * @param pointX a point on the axis, mm
 * @param pointY a point on the axis, mm
 * @param pointZ a point on the axis, mm
 * @param angle rotation angle, rad; within 0 to pi if computed from a motion
 * @param slide translation along the direction, mm
 */
public record HelicalAxis(
        double directionX,
        double directionY,
        double directionZ,
        double pointX,
        double pointY,
        double pointZ,
        double angle,
        double slide) {

    /** Rotation angle below which a motion is treated as a pure translation, rad: the level of rounding errors. */
    public static final double MIN_ANGLE = 1e-13;

    private static final double UNIT_TOLERANCE = 1e-9;
    /** Error of a direction's length below which it is kept to the bit: its rotations are orthonormal to 1e-9. */
    private static final double EXACT_TOLERANCE = 1e-11;

    public HelicalAxis {
        double length = norm(directionX, directionY, directionZ);
        if (!(Math.abs(length - 1) <= UNIT_TOLERANCE)) {
            throw new IllegalArgumentException("helical axis: direction of length " + length + ", expected 1");
        }
        if (!Double.isFinite(pointX + pointY + pointZ + angle + slide)) {
            throw new IllegalArgumentException("helical axis: point (" + pointX + ", " + pointY + ", " + pointZ
                    + "), angle " + angle + ", slide " + slide + ", expected finite numbers");
        }
        if (Math.abs(length - 1) > EXACT_TOLERANCE) {
            directionX /= length;
            directionY /= length;
            directionZ /= length;
        }
    }

    /**
     * The axis along a direction of any length through a point.
     *
     * @param direction 3 numbers, not all 0
     * @param point 3 numbers, mm
     * @throws IllegalArgumentException if the direction has no length or a number is not finite
     */
    public static HelicalAxis through(double[] direction, double[] point, double angle, double slide) {
        double length = norm(direction[0], direction[1], direction[2]);
        if (!(length > 0) || !Double.isFinite(length)) {
            throw new IllegalArgumentException("helical axis: direction (" + direction[0] + ", " + direction[1] + ", "
                    + direction[2] + ") has no length, expected one to turn about");
        }
        double x = direction[0] / length;
        double y = direction[1] / length;
        double z = direction[2] / length;
        return new HelicalAxis(x, y, z, point[0], point[1], point[2], angle, slide);
    }

    /** The screw of a motion; the point is the one nearest to the origin. See {@link #of(RigidMotion, double[])}. */
    public static HelicalAxis of(RigidMotion motion) {
        return of(motion, new double[3]);
    }

    /**
     * The screw of a motion. A pure translation has no unique axis: it becomes a slide with angle 0 through the
     * reference point, along the translation (along z for the identity). A rotation by pi has two equivalent screws;
     * rounding decides which is returned.
     *
     * @param reference the point of the axis nearest to this one is chosen, mm
     */
    public static HelicalAxis of(RigidMotion motion, double[] reference) {
        double[] v = {motion.translation(0), motion.translation(1), motion.translation(2)};
        double[] q = quaternion(motion);
        double sine = norm(q[1], q[2], q[3]);
        double angle = 2 * StrictMath.atan2(sine, q[0]);
        if (angle < MIN_ANGLE) {
            double shift = norm(v[0], v[1], v[2]);
            return through(shift > 0 ? v : new double[] {0, 0, 1}, reference, 0, shift);
        }
        double x = q[1] / sine;
        double y = q[2] / sine;
        double z = q[3] / sine;
        double slide = x * v[0] + y * v[1] + z * v[2];
        double cotangent = q[0] / sine;
        double px = 0.5 * (v[0] - slide * x + cotangent * (y * v[2] - z * v[1]));
        double py = 0.5 * (v[1] - slide * y + cotangent * (z * v[0] - x * v[2]));
        double pz = 0.5 * (v[2] - slide * z + cotangent * (x * v[1] - y * v[0]));
        double along = (reference[0] - px) * x + (reference[1] - py) * y + (reference[2] - pz) * z;
        return new HelicalAxis(x, y, z, px + along * x, py + along * y, pz + along * z, angle, slide);
    }

    /** The full motion. */
    public RigidMotion motion() {
        return motion(1);
    }

    /** A fraction of the motion: {@code fraction} of the angle and of the slide; may be negative or above 1. */
    public RigidMotion motion(double fraction) {
        double[] p = new double[HelicalBody.POSE_LENGTH];
        new HelicalBody(this).pose(fraction, p);
        return RigidMotion.of(
                new double[] {p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10]}, new double[] {p[3], p[7], p[11]});
    }

    /**
     * The screw mirrored at {@code x = 0}, for the other half of a body. Rotation is an axial vector, so its y and z
     * components change sign. The slide is measured along this direction and changes sign too.
     */
    public HelicalAxis mirroredX() {
        return new HelicalAxis(directionX, -directionY, -directionZ, -pointX, pointY, pointZ, angle, -slide);
    }

    /** The same screw of a body that a rigid motion has moved: direction and point are moved, angle and slide stay. */
    public HelicalAxis movedBy(RigidMotion motion) {
        double[] turned = new double[3];
        for (int row = 0; row < 3; row++) {
            turned[row] = motion.rotation(row, 0) * directionX
                    + motion.rotation(row, 1) * directionY
                    + motion.rotation(row, 2) * directionZ;
        }
        return through(turned, motion.apply(pointX, pointY, pointZ), angle, slide);
    }

    /** The unit quaternion w, x, y, z of the rotation, w >= 0, from its largest component (S. W. Shepperd 1978). */
    private static double[] quaternion(RigidMotion m) {
        double[] squares = {
            1 + m.rotation(0, 0) + m.rotation(1, 1) + m.rotation(2, 2),
            1 + m.rotation(0, 0) - m.rotation(1, 1) - m.rotation(2, 2),
            1 - m.rotation(0, 0) + m.rotation(1, 1) - m.rotation(2, 2),
            1 - m.rotation(0, 0) - m.rotation(1, 1) + m.rotation(2, 2)
        };
        int largest = 0;
        for (int i = 1; i < 4; i++) {
            if (squares[i] > squares[largest]) {
                largest = i;
            }
        }
        double xy = m.rotation(0, 1) + m.rotation(1, 0);
        double xz = m.rotation(0, 2) + m.rotation(2, 0);
        double yz = m.rotation(1, 2) + m.rotation(2, 1);
        double wx = m.rotation(2, 1) - m.rotation(1, 2);
        double wy = m.rotation(0, 2) - m.rotation(2, 0);
        double wz = m.rotation(1, 0) - m.rotation(0, 1);
        double s = squares[largest];
        double[] q =
                switch (largest) {
                    case 0 -> new double[] {s, wx, wy, wz};
                    case 1 -> new double[] {wx, s, xy, xz};
                    case 2 -> new double[] {wy, xy, s, yz};
                    default -> new double[] {wz, xz, yz, s};
                };
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        double sign = q[0] < 0 ? -1 : 1;
        for (int i = 0; i < 4; i++) {
            q[i] *= sign / length;
        }
        return q;
    }

    private static double norm(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
