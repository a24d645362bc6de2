package org.phrenic.engine.force;

import java.util.Arrays;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * Pressure on selected triangles. Each corner carries a third of p w A n, where n is the inward unit normal of the
 * current triangle, so positive pressure pushes against the face. w is a weight for each triangle (1, or a hydrostatic
 * profile). An optional second pressure has its own weights.
 */
public final class FacePressure implements ForceField {
    /** Bit mask of a triangle whose three corners all lie in the block. */
    private static final int ALL = 7;

    private final int[] start;
    private final int[] corner;
    private final int[] owned;
    private final double[] entryWeight;
    private final double[] entrySecondaryWeight;
    private double pressure;
    private double secondaryPressure;

    /**
     * @param layout layout of the system
     * @param triangles three nodes a triangle, caller's numbering, anticlockwise seen from the side under pressure
     * @param weight one a triangle
     * @throws IllegalArgumentException if there are not three corners and one weight for each triangle
     */
    public FacePressure(NodeLayout layout, int[] triangles, double[] weight) {
        this(layout, triangles, weight, new double[weight.length]);
    }

    /**
     * As the other constructor, with a second pressure.
     *
     * @param moreWeight weights of the second pressure, one a triangle
     */
    public FacePressure(NodeLayout layout, int[] triangles, double[] weight, double[] moreWeight) {
        int count = triangles.length / 3;
        if (triangles.length % 3 != 0 || weight.length != count || moreWeight.length != count) {
            throw new IllegalArgumentException("faces under pressure: found " + triangles.length + " corners and "
                    + weight.length + " weights, expected three corners and one weight each");
        }
        int[] internal = new int[triangles.length];
        long[] key = new long[3 * count];
        int entries = 0;
        for (int t = 0; t < count; t++) {
            entries = enter(t, triangles, layout, internal, key, entries);
        }
        key = Arrays.copyOf(key, entries);
        RadixSort.sort(key);
        start = new int[layout.blockCount() + 1];
        corner = new int[3 * entries];
        owned = new int[entries];
        entryWeight = new double[entries];
        entrySecondaryWeight = new double[entries];
        for (int i = 0; i < entries; i++) {
            int triangle = (int) key[i];
            entryWeight[i] = weight[triangle];
            entrySecondaryWeight[i] = moreWeight[triangle];
            take(i, (int) (key[i] >>> 32), 3 * triangle, layout, internal);
        }
        for (int b = 0; b < layout.blockCount(); b++) {
            start[b + 1] += start[b];
        }
    }

    /** Adds a triangle once for each block that contains one of its corners; returns the new number of entries. */
    private static int enter(int t, int[] triangles, NodeLayout layout, int[] internal, long[] key, int entries) {
        for (int c = 0; c < 3; c++) {
            internal[3 * t + c] = layout.internal(triangles[3 * t + c]);
        }
        int a = layout.blockOf(internal[3 * t]);
        int b = layout.blockOf(internal[3 * t + 1]);
        int c = layout.blockOf(internal[3 * t + 2]);
        int end = entries;
        key[end++] = (long) a << 32 | t;
        if (b != a) {
            key[end++] = (long) b << 32 | t;
        }
        if (c != a && c != b) {
            key[end++] = (long) c << 32 | t;
        }
        return end;
    }

    private void take(int entry, int block, int corners, NodeLayout layout, int[] internal) {
        start[block + 1]++;
        for (int c = 0; c < 3; c++) {
            int node = internal[corners + c];
            corner[3 * entry + c] = 3 * node;
            if (layout.blockOf(node) == block) {
                owned[entry] |= 1 << c;
            }
        }
    }

    /** Sets the pressure, kPa (mN/mm²). */
    public void setPressure(double value) {
        pressure = value;
    }

    /** Sets the second pressure, kPa. */
    public void setSecondaryPressure(double value) {
        secondaryPressure = value;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        if (pressure == 0 && secondaryPressure == 0) {
            return;
        }
        int end = start[block + 1];
        for (int from = start[block]; from < end; from += NodeLayout.LOOP_CHUNK) {
            press(x, force, from, Math.min(end, from + NodeLayout.LOOP_CHUNK));
        }
    }

    private void press(double[] x, double[] force, int from, int end) {
        int[] corners = corner;
        int[] mask = owned;
        double[] scale = entryWeight;
        double sixth = -pressure / 6;
        for (int i = from; i < end; i++) {
            int a = corners[3 * i];
            int b = corners[3 * i + 1];
            int c = corners[3 * i + 2];
            double e1x = x[b] - x[a];
            double e1y = x[b + 1] - x[a + 1];
            double e1z = x[b + 2] - x[a + 2];
            double e2x = x[c] - x[a];
            double e2y = x[c + 1] - x[a + 1];
            double e2z = x[c + 2] - x[a + 2];
            double s = secondaryPressure == 0
                    ? sixth * scale[i]
                    : sixth * scale[i] - secondaryPressure * entrySecondaryWeight[i] / 6;
            double fx = s * (e1y * e2z - e1z * e2y);
            double fy = s * (e1z * e2x - e1x * e2z);
            double fz = s * (e1x * e2y - e1y * e2x);
            int mine = mask[i];
            if (mine == ALL) {
                SpringKernel.add(force, a, fx, fy, fz);
                SpringKernel.add(force, b, fx, fy, fz);
                SpringKernel.add(force, c, fx, fy, fz);
                continue;
            }
            if ((mine & 1) != 0) {
                SpringKernel.add(force, a, fx, fy, fz);
            }
            if ((mine & 2) != 0) {
                SpringKernel.add(force, b, fx, fy, fz);
            }
            if ((mine & 4) != 0) {
                SpringKernel.add(force, c, fx, fy, fz);
            }
        }
    }
}
