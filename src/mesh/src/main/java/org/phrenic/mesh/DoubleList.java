package org.phrenic.mesh;

import java.util.Arrays;

/** A growing list of real numbers without boxing. */
public final class DoubleList {
    private double[] values = new double[192];
    private int size;

    public void add(double value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, (int) Math.min(2L * size, Integer.MAX_VALUE - 8));
        }
        values[size++] = value;
    }

    /** Appends a point; returns its number among the points so far, three numbers each. */
    public int add(double x, double y, double z) {
        add(x);
        add(y);
        add(z);
        return size / 3 - 1;
    }

    /** Squared distance of two of the points, three numbers each. */
    public double squaredDistance(int a, int b) {
        return Vectors.squaredDistance(values, a, b);
    }

    public double get(int index) {
        return values[index];
    }

    public int size() {
        return size;
    }

    public double[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
