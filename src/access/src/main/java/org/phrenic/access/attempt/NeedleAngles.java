package org.phrenic.access.attempt;

import org.phrenic.mesh.Vectors;

/**
 * The direction of a needle as two angles, degrees: {@code d = (cos c sin a, cos c cos a, sin c)} in LPS.
 *
 * @param axialDeg a, in the axial plane: 0 straight back, 90 toward the patient's left
 * @param cranialDeg c, out of the axial plane: positive toward the head, within 90
 */
public record NeedleAngles(double axialDeg, double cranialDeg) {
    public NeedleAngles {
        if (!(Math.abs(axialDeg) <= 360 && Math.abs(cranialDeg) <= 90)) {
            throw new IllegalArgumentException("needle: found angles of " + axialDeg + " and " + cranialDeg
                    + " degrees, expected them within 360 and 90");
        }
    }

    /** The angles of a direction. */
    public static NeedleAngles of(double[] direction) {
        double[] d = Vectors.normalize(direction);
        return new NeedleAngles(
                StrictMath.toDegrees(StrictMath.atan2(d[0], d[1])),
                StrictMath.toDegrees(StrictMath.asin(Math.max(-1, Math.min(1, d[2])))));
    }

    /** Unit vector from the skin to the tip, LPS. */
    public double[] direction() {
        double a = StrictMath.toRadians(axialDeg);
        double c = StrictMath.toRadians(cranialDeg);
        return Vectors.of(
                StrictMath.cos(c) * StrictMath.sin(a), StrictMath.cos(c) * StrictMath.cos(a), StrictMath.sin(c));
    }

    /**
     * The angles of a needle tilted by so much in two directions at a right angle to it and to each other: level, as a
     * greater axial angle turns it, and toward the head.
     */
    public NeedleAngles tilted(double levelDeg, double headDeg) {
        double tiltDeg = Math.sqrt(levelDeg * levelDeg + headDeg * headDeg);
        if (tiltDeg == 0) {
            return this;
        }
        double a = StrictMath.toRadians(axialDeg);
        double c = StrictMath.toRadians(cranialDeg);
        double[] level = {StrictMath.cos(a), -StrictMath.sin(a), 0};
        double[] head = {
            -StrictMath.sin(c) * StrictMath.sin(a), -StrictMath.sin(c) * StrictMath.cos(a), StrictMath.cos(c)
        };
        double tilt = StrictMath.toRadians(tiltDeg);
        double aside = StrictMath.sin(tilt) / tiltDeg;
        double[] along = Vectors.addScaled(new double[3], direction(), StrictMath.cos(tilt));
        return of(Vectors.addScaled(Vectors.addScaled(along, level, aside * levelDeg), head, aside * headDeg));
    }

    /** The angles turned by so much; the second stays within 90 degrees. */
    public NeedleAngles turned(double byAxialDeg, double byCranialDeg) {
        double a = axialDeg + byAxialDeg;
        double wrapped = a > 180 ? a - 360 : a <= -180 ? a + 360 : a;
        return new NeedleAngles(wrapped, Math.max(-89, Math.min(89, cranialDeg + byCranialDeg)));
    }
}
