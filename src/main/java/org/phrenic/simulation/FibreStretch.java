package org.phrenic.simulation;

import org.phrenic.anatomy.Diaphragm;

/** Mean length of the muscle's fibres against rest: the stretch |F f| of the fibre direction f in each triangle, weighted by its area at rest. */
final class FibreStretch {
    private final Diaphragm diaphragm;
    private final int first;

    FibreStretch(DiaphragmPart part) {
        diaphragm = part.diaphragm;
        first = part.first;
    }

    /** Shortening in per cent, positive when shorter. */
    double shorteningPercent(double[] rest, double[] now) {
        double sum = 0;
        double area = 0;
        int[] t = diaphragm.sheet().triangles();
        double[] fibre = diaphragm.fibreDirections();
        for (int i = 0; i < t.length; i += 3) {
            int a = 3 * (first + t[i]);
            int b = 3 * (first + t[i + 1]);
            int c = 3 * (first + t[i + 2]);
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
                r1 += e1 * fibre[i + k];
                r2 += e2 * fibre[i + k];
            }
            double determinant = g11 * g22 - g12 * g12;
            if (r1 * r1 + r2 * r2 == 0 || determinant <= 0) {
                continue;
            }
            double u = (g22 * r1 - g12 * r2) / determinant;
            double v = (g11 * r2 - g12 * r1) / determinant;
            double squaredNow = 0;
            double squaredRest = 0;
            for (int k = 0; k < 3; k++) {
                double moved = u * (now[b + k] - now[a + k]) + v * (now[c + k] - now[a + k]);
                double still = u * (rest[b + k] - rest[a + k]) + v * (rest[c + k] - rest[a + k]);
                squaredNow += moved * moved;
                squaredRest += still * still;
            }
            double weight = 0.5 * Math.sqrt(determinant);
            sum += weight * Math.sqrt(squaredNow / squaredRest);
            area += weight;
        }
        return area == 0 ? 0 : 100 * (1 - sum / area);
    }
}
