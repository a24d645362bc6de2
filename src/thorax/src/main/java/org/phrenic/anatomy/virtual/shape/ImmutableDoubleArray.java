package org.phrenic.anatomy.virtual.shape;

import java.util.Arrays;

/** An immutable array of doubles. */
public final class ImmutableDoubleArray {
    private final double[] values;

    private ImmutableDoubleArray(double[] values) {
        this.values = values;
    }

    /** Creates an array of these values; the argument is copied. */
    public static ImmutableDoubleArray of(double... values) {
        return new ImmutableDoubleArray(values.clone());
    }

    /** Returns the element at a zero-based index. */
    public double at(int index) {
        return values[index];
    }

    /** Number of elements. */
    public int size() {
        return values.length;
    }

    /** Returns a copy of the elements. */
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
