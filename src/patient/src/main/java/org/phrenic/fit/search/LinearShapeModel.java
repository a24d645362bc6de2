package org.phrenic.fit.search;

/**
 * Where the vertices of a body go near a place of the unit cube, as far as that is linear: the shape there, and its
 * change with each parameter. Learns from every breath (Broyden 1965, doi 10.1090/S0025-5718-1965-0198670-6, a vertex
 * coordinate a row).
 */
public final class LinearShapeModel {
    /** What lies nearer teaches noise. */
    private static final double LEAST_WAY = 0.01;

    private final double[][] derivative;
    private double[] centre;
    private double[] shape;

    LinearShapeModel(int dimension) {
        derivative = new double[dimension][];
    }

    /** Where it stands. */
    public double[] centre() {
        return centre;
    }

    /** Change of the shape with a parameter. */
    public double[] derivative(int parameter) {
        return derivative[parameter];
    }

    /** Moves to a place whose shape is known; what the shape changes by stays. */
    void recentre(double[] place, float[] known) {
        centre = place.clone();
        shape = new double[known.length];
        for (int i = 0; i < shape.length; i++) {
            shape[i] = known[i];
        }
        for (int k = 0; k < derivative.length; k++) {
            if (derivative[k] == null) {
                derivative[k] = new double[shape.length];
            }
        }
    }

    /** Takes the change with one parameter from a place where it alone differs. */
    void setFiniteDifference(int parameter, double way, float[] other) {
        for (int i = 0; i < shape.length; i++) {
            derivative[parameter][i] = (other[i] - shape[i]) / way;
        }
    }

    /** Writes the shape expected at a place. */
    public void predict(double[] place, double[] out) {
        System.arraycopy(shape, 0, out, 0, shape.length);
        for (int k = 0; k < place.length; k++) {
            double way = place[k] - centre[k];
            if (way != 0) {
                for (int i = 0; i < out.length; i++) {
                    out[i] += way * derivative[k][i];
                }
            }
        }
    }

    /** Corrects the changes by the least that makes them explain the shape at another place. */
    void broydenUpdate(double[] place, float[] other) {
        double squared = 0;
        for (int k = 0; k < place.length; k++) {
            squared += (place[k] - centre[k]) * (place[k] - centre[k]);
        }
        if (squared < LEAST_WAY * LEAST_WAY) {
            return;
        }
        double[] missed = new double[shape.length];
        predict(place, missed);
        for (int i = 0; i < missed.length; i++) {
            missed[i] = other[i] - missed[i];
        }
        for (int k = 0; k < place.length; k++) {
            double share = (place[k] - centre[k]) / squared;
            if (share != 0) {
                for (int i = 0; i < missed.length; i++) {
                    derivative[k][i] += share * missed[i];
                }
            }
        }
    }

    /** Length of a shape. */
    public int length() {
        return shape.length;
    }
}
