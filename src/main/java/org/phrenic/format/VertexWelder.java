package org.phrenic.format;

import java.util.Arrays;

/**
 * Gives equal points one index, in the order they are first seen. Equal means the same bits in all three coordinates, with -0
 * taken as 0: STL writes every corner out, and corners of one vertex are written alike.
 */
final class VertexWelder {
    private static final int FREE = -1;

    private final PolygonSoup soup;
    private double[] points = new double[3 * 512];
    private int[] slots = new int[1024];
    private int count;

    VertexWelder(PolygonSoup soup) {
        this.soup = soup;
        Arrays.fill(slots, FREE);
    }

    /** The index of (x, y, z) in the soup, which gets it as a vertex if it is new. */
    int index(Source source, double x, double y, double z) {
        // Adding zero turns -0 into 0 and leaves every other number as it is.
        double px = x + 0.0;
        double py = y + 0.0;
        double pz = z + 0.0;
        int slot = slotOf(px, py, pz);
        if (slots[slot] != FREE) {
            return slots[slot];
        }
        soup.vertex(source, px, py, pz);
        if (3 * count == points.length) {
            points = Arrays.copyOf(points, 2 * points.length);
        }
        points[3 * count] = px;
        points[3 * count + 1] = py;
        points[3 * count + 2] = pz;
        slots[slot] = count++;
        int index = slots[slot];
        if (2 * count >= slots.length) {
            rehash();
        }
        return index;
    }

    private void rehash() {
        slots = new int[2 * slots.length];
        Arrays.fill(slots, FREE);
        for (int i = 0; i < count; i++) {
            slots[slotOf(points[3 * i], points[3 * i + 1], points[3 * i + 2])] = i;
        }
    }

    private int slotOf(double x, double y, double z) {
        long hash = Double.doubleToLongBits(x);
        hash = 0x9E3779B97F4A7C15L * (hash ^ (hash >>> 29)) + Double.doubleToLongBits(y);
        hash = 0x9E3779B97F4A7C15L * (hash ^ (hash >>> 29)) + Double.doubleToLongBits(z);
        hash = 0x9E3779B97F4A7C15L * (hash ^ (hash >>> 29));
        int slot = (int) (hash >>> 33) & (slots.length - 1);
        while (slots[slot] != FREE && !isAt(slots[slot], x, y, z)) {
            slot = (slot + 1) & (slots.length - 1);
        }
        return slot;
    }

    private boolean isAt(int i, double x, double y, double z) {
        return points[3 * i] == x && points[3 * i + 1] == y && points[3 * i + 2] == z;
    }
}
