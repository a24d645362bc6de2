package org.phrenic.anatomy.virtual;

import java.util.Arrays;

/** A row of numbers that does not change. */
public final class ImmutableDoubleArray {
    private final double[] values;

    private ImmutableDoubleArray(double[] values) {
        this.values = values;
    }

    /** These numbers; the array is copied. */
    public static ImmutableDoubleArray of(double... values) {
        return new ImmutableDoubleArray(values.clone());
    }

    /** The number at this place, from 0. */
    public double at(int index) {
        return values[index];
    }

    /** How many there are. */
    public int size() {
        return values.length;
    }

    /** A copy of them. */
    public double[] toArray() {
        return values.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ImmutableDoubleArray that && Arrays.equals(values, that.values);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(values);
    }

    @Override
    public String toString() {
        return Arrays.toString(values);
    }
}
