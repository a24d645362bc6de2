package org.phrenic.mesh;

import java.util.Arrays;

/** A growable list of doubles without boxing. */
public final class DoubleList {
    private double[] values = new double[192];
    private int size;

    public void add(double value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, (int) Math.min(2L * size, Integer.MAX_VALUE - 8));
        }
        values[size++] = value;
    }

    /** Appends a point of three numbers; returns its point index. */
    public int add(double x, double y, double z) {
        add(x);
        add(y);
        add(z);
        return size / 3 - 1;
    }

    /** Squared distance between two points, given by their point indices. */
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
