package org.phrenic.access.imaging;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * A needle as X-rays see it: a cylinder of steel. Its mass attenuation is that of iron (Hubbell and Seltzer, NIST
 * Standard Reference Database 126, doi 10.18434/T4D01F), its density 7.9 g/cm3.
 *
 * @param from one end, LPS, mm
 * @param to the other end, LPS, mm
 * @param radiusMm radius, mm
 */
public record SteelRod(double[] from, double[] to, double radiusMm) {
    private static final double DENSITY = 7.9;
    /** Iron at 40, 60 and 80 keV. */
    private static final double[] CM2_PER_G = {3.629, 1.205, 0.5952};

    private static final int SIDES = 16;

    /** Linear attenuation coefficient, 1/mm. */
    static double attenuationPerMm(double energyKev) {
        return DENSITY * Tissue.interpolate(CM2_PER_G, energyKev) / 10;
    }

    /** A closed prism of the same cross-section. */
    TriangleMesh mesh() {
        double[] axis = Vectors.normalize(Vectors.subtract(to, from));
        double[] any = Math.abs(axis[0]) < 0.8 ? Vectors.of(1, 0, 0) : Vectors.of(0, 1, 0);
        double[] u = Vectors.orthonormalize(any, axis);
        double[] v = Vectors.cross(axis, u);
        // A regular polygon of the circle's area.
        double corner = radiusMm * Math.sqrt(Math.PI / (0.5 * SIDES * StrictMath.sin(2 * Math.PI / SIDES)));
        double[] p = new double[3 * (2 * SIDES + 2)];
        int[] t = new int[3 * 4 * SIDES];
        for (int k = 0; k < SIDES; k++) {
            double angle = 2 * Math.PI * k / SIDES;
            double a = corner * StrictMath.cos(angle);
            double b = corner * StrictMath.sin(angle);
            for (int axisIndex = 0; axisIndex < 3; axisIndex++) {
                double off = a * u[axisIndex] + b * v[axisIndex];
                p[3 * k + axisIndex] = from[axisIndex] + off;
                p[3 * (SIDES + k) + axisIndex] = to[axisIndex] + off;
            }
            int next = (k + 1) % SIDES;
            int[] faces = {
                2 * SIDES,
                next,
                k,
                2 * SIDES + 1,
                SIDES + k,
                SIDES + next,
                k,
                next,
                SIDES + k,
                next,
                SIDES + next,
                SIDES + k
            };
            System.arraycopy(faces, 0, t, 12 * k, 12);
        }
        System.arraycopy(from, 0, p, 6 * SIDES, 3);
        System.arraycopy(to, 0, p, 6 * SIDES + 3, 3);
        return new TriangleMesh(p, t);
    }
}
