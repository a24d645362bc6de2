package org.phrenic.simulation.observe;

import java.util.Arrays;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.model.organ.DiaphragmPart;

/**
 * Mean shortening of the muscle fibres from rest. The stretch |F f| of the fibre direction f in each triangle is
 * weighted by the triangle's rest area.
 */
public final class FibreShortening {
    /** Three corners of each triangle that has fibres, as offsets into positions (3 × node). */
    private final int[] corners;
    /**
     * The fibre direction as a linear combination of the two edges at the first corner, two coefficients per triangle.
     */
    private final double[] edgeComponents;
    /** Area at rest, mm². */
    private final double[] area;
    /** Squared length of the fibre direction at rest. */
    private final double[] squaredRest;

    /**
     * @param part the diaphragm in the scene
     * @param rest positions of the whole scene at rest, caller's order, mm
     */
    public FibreShortening(DiaphragmPart part, double[] rest) {
        Diaphragm diaphragm = part.diaphragm;
        int[] t = diaphragm.sheet().triangles();
        int[] found = new int[t.length];
        double[] edges = new double[2 * t.length / 3];
        double[] areas = new double[t.length / 3];
        double[] squared = new double[t.length / 3];
        int n = 0;
        for (int i = 0; i < t.length; i += 3) {
            for (int corner = 0; corner < 3; corner++) {
                found[3 * n + corner] = 3 * (part.firstNode + t[i + corner]);
            }
            n += resolve(rest, found, n, diaphragm.fibreDirections(), i, edges, areas, squared) ? 1 : 0;
        }
        corners = Arrays.copyOf(found, 3 * n);
        edgeComponents = Arrays.copyOf(edges, 2 * n);
        area = Arrays.copyOf(areas, n);
        squaredRest = Arrays.copyOf(squared, n);
    }

    /** Computes the values of triangle n; false if it has no fibres or no area. */
    private static boolean resolve(
            double[] rest,
            int[] corners,
            int n,
            double[] fibre,
            int f,
            double[] parts,
            double[] areas,
            double[] squaredRest) {
        int a = corners[3 * n];
        int b = corners[3 * n + 1];
        int c = corners[3 * n + 2];
        double g11 = 0;
        double g12 = 0;
        double g22 = 0;
        double r1 = 0;
        double r2 = 0;
        for (int k = 0; k < 3; k++) {
            double e1 = rest[b + k] - rest[a + k];
            double e2 = rest[c + k] - rest[a + k];
            g11 += e1 * e1;
            g12 += e1 * e2;
            g22 += e2 * e2;
            r1 += e1 * fibre[f + k];
            r2 += e2 * fibre[f + k];
        }
        double determinant = g11 * g22 - g12 * g12;
        if (r1 * r1 + r2 * r2 == 0 || determinant <= 0) {
            return false;
        }
        parts[2 * n] = (g22 * r1 - g12 * r2) / determinant;
        parts[2 * n + 1] = (g11 * r2 - g12 * r1) / determinant;
        areas[n] = 0.5 * Math.sqrt(determinant);
        squaredRest[n] = squaredLength(rest, a, b, c, parts[2 * n], parts[2 * n + 1]);
        return true;
    }

    private static double squaredLength(double[] p, int a, int b, int c, double u, double v) {
        double x = u * (p[b] - p[a]) + v * (p[c] - p[a]);
        double y = u * (p[b + 1] - p[a + 1]) + v * (p[c + 1] - p[a + 1]);
        double z = u * (p[b + 2] - p[a + 2]) + v * (p[c + 2] - p[a + 2]);
        return x * x + y * y + z * z;
    }

    /**
     * Fibre shortening in per cent, positive when shorter. Allocates nothing.
     *
     * @param now current positions of the whole scene, caller's order, mm
     */
    public double shorteningPercent(double[] now) {
        double sum = 0;
        double all = 0;
        for (int n = 0; n < area.length; n++) {
            int a = corners[3 * n];
            int b = corners[3 * n + 1];
            int c = corners[3 * n + 2];
            double squared = squaredLength(now, a, b, c, edgeComponents[2 * n], edgeComponents[2 * n + 1]);
            sum += area[n] * Math.sqrt(squared / squaredRest[n]);
            all += area[n];
        }
        return all == 0 ? 0 : 100 * (1 - sum / all);
    }
}
