package org.phrenic.study.fit;

/**
 * Where the vertices of a body go near a place of the unit cube, as far as that is linear: the shape there, and its change with each parameter. Learns from every breath (Broyden 1965, doi 10.1090/S0025-5718-1965-0198670-6, a vertex
 * coordinate a row).
 */
final class LinearBody {
    /** What lies nearer teaches noise. */
    private static final double LEAST_WAY = 0.01;

    private final double[][] change;
    private double[] at;
    private double[] shape;

    LinearBody(int dimension) {
        change = new double[dimension][];
    }

    /** Where it stands. */
    double[] at() {
        return at;
    }

    /** Change of the shape with a parameter. */
    double[] change(int parameter) {
        return change[parameter];
    }

    /** Moves to a place whose shape is known; what the shape changes by stays. */
    void standAt(double[] place, float[] known) {
        at = place.clone();
        shape = new double[known.length];
        for (int i = 0; i < shape.length; i++) {
            shape[i] = known[i];
        }
        for (int k = 0; k < change.length; k++) {
            if (change[k] == null) {
                change[k] = new double[shape.length];
            }
        }
    }

    /** Takes the change with one parameter from a place where it alone differs. */
    void measure(int parameter, double way, float[] other) {
        for (int i = 0; i < shape.length; i++) {
            change[parameter][i] = (other[i] - shape[i]) / way;
        }
    }

    /** Writes the shape expected at a place. */
    void shapeAt(double[] place, double[] out) {
        System.arraycopy(shape, 0, out, 0, shape.length);
        for (int k = 0; k < place.length; k++) {
            double way = place[k] - at[k];
            if (way != 0) {
                for (int i = 0; i < out.length; i++) {
                    out[i] += way * change[k][i];
                }
            }
        }
    }

    /** Corrects the changes by the least that makes them explain the shape at another place. */
    void learn(double[] place, float[] other) {
        double squared = 0;
        for (int k = 0; k < place.length; k++) {
            squared += (place[k] - at[k]) * (place[k] - at[k]);
        }
        if (squared < LEAST_WAY * LEAST_WAY) {
            return;
        }
        double[] missed = new double[shape.length];
        shapeAt(place, missed);
        for (int i = 0; i < missed.length; i++) {
            missed[i] = other[i] - missed[i];
        }
        for (int k = 0; k < place.length; k++) {
            double share = (place[k] - at[k]) / squared;
            if (share != 0) {
                for (int i = 0; i < missed.length; i++) {
                    change[k][i] += share * missed[i];
                }
            }
        }
    }

    /** Length of a shape. */
    int length() {
        return shape.length;
    }
}
