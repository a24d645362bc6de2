package org.phrenic.fit;

/** Part of a surface to compare: the whole surface, or one colour of a checkerboard in the transverse plane. */
public enum FitHalf {
    ALL,
    EVEN,
    ODD;

    /** Side length of a square, mm. A square covers several mesh edges, and a dome covers a few squares. */
    private static final double SQUARE_MM = 40;

    boolean contains(double x, double y) {
        boolean even = ((long) Math.floor(x / SQUARE_MM) + (long) Math.floor(y / SQUARE_MM)) % 2 == 0;
        return this == ALL || even == (this == EVEN);
    }

    /** The squares that this half leaves out. */
    FitHalf other() {
        return this == EVEN ? ODD : EVEN;
    }
}
