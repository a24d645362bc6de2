package org.phrenic.patient.registration;

import org.phrenic.mesh.DoubleList;

/**
 * Pairs of a point of the template, at its original place, and the point of the scan that corresponds to it, each with
 * the standard deviation of the correspondence in mm.
 */
final class PointPairs {
    private final DoubleList from = new DoubleList();
    private final DoubleList to = new DoubleList();
    private final DoubleList sigma = new DoubleList();

    void add(double[] template, double[] scan, double sigmaMm) {
        from.add(template[0], template[1], template[2]);
        to.add(scan[0], scan[1], scan[2]);
        sigma.add(sigmaMm);
    }

    /** Adds pairs of points given as x, y, z in turn. */
    void addAll(double[] template, double[] scan, double sigmaMm) {
        for (int i = 0; i < template.length; i += 3) {
            from.add(template[i], template[i + 1], template[i + 2]);
            to.add(scan[i], scan[i + 1], scan[i + 2]);
            sigma.add(sigmaMm);
        }
    }

    void addAll(PointPairs other) {
        addAll(other, 1);
    }

    /** Adds other pairs with their standard deviations scaled. */
    void addAll(PointPairs other, double scale) {
        for (int i = 0; i < other.count(); i++) {
            for (int k = 3 * i; k < 3 * i + 3; k++) {
                from.add(other.from.get(k));
                to.add(other.to.get(k));
            }
            sigma.add(scale * other.sigma.get(i));
        }
    }

    int count() {
        return sigma.size();
    }

    double[] from() {
        return from.toArray();
    }

    double[] to() {
        return to.toArray();
    }

    double[] sigma() {
        return sigma.toArray();
    }

    /** Weights {@code 1 / sigma^2} of the pairs. */
    double[] weights() {
        double[] weights = sigma.toArray();
        for (int i = 0; i < weights.length; i++) {
            weights[i] = 1 / (weights[i] * weights[i]);
        }
        return weights;
    }

    /** Weighted mean of points given as x, y, z in turn. */
    static double[] centroid(double[] points, double[] weights) {
        double[] c = new double[3];
        double total = 0;
        for (int i = 0; i < weights.length; i++) {
            total += weights[i];
            for (int k = 0; k < 3; k++) {
                c[k] += weights[i] * points[3 * i + k];
            }
        }
        return new double[] {c[0] / total, c[1] / total, c[2] / total};
    }
}
