package org.phrenic.access;

import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.MovingLeastSquares;

/**
 * Motion of points inside the liver, derived from the motion of its surface. A point is a fixed affine combination of
 * the surface vertices, {@code x = sum c_i x_i} ({@link MovingLeastSquares}).
 */
public final class LiverTissue {
    private static final int MAX_ITERATIONS = 60;
    private static final double TOLERANCE_MM = 1e-9;

    private final double[] rest;
    private final MovingStructure liver;

    /** A point of the tissue: rest position (LPS, mm) and one coefficient per liver vertex. */
    public record Point(double[] rest, double[] coefficients) {}

    /** @param anatomy provides the current vertex positions */
    public LiverTissue(MovingAnatomy anatomy) {
        liver = anatomy.liver();
        rest = liver.surface().rest().positions();
    }

    /** Returns the tissue point at a rest position, LPS, mm. */
    public Point pointAtRest(double[] place) {
        return new Point(place.clone(), MovingLeastSquares.coefficients(rest, place));
    }

    /** Position of a tissue point in the current frame, LPS, mm. */
    public double[] position(Point point) {
        double[] p = liver.positions();
        double[] at = new double[3];
        for (int i = 0; i < point.coefficients.length; i++) {
            double c = point.coefficients[i];
            at[0] += c * p[3 * i];
            at[1] += c * p[3 * i + 1];
            at[2] += c * p[3 * i + 2];
        }
        return liver.toWorld(at);
    }

    /** Returns the tissue point at a current position. Its rest position is found by fixed-point iteration. */
    public Point pointNowAt(double[] place) {
        Point point = pointAtRest(place);
        for (int i = 0; i < MAX_ITERATIONS; i++) {
            double[] error = Vectors.subtract(place, position(point));
            if (Vectors.length(error) < TOLERANCE_MM) {
                break;
            }
            point = pointAtRest(Vectors.addScaled(point.rest, error, 1));
        }
        return point;
    }
}
