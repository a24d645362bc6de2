package org.phrenic.fit;

/** The region of a surface that is compared: all of it, or one colour of a chessboard in the transverse plane. */
public enum FitHalf {
    ALL,
    FITTED,
    HELD_OUT;

    /** Side of a square, mm: several mesh edges, and a few squares on a dome. */
    private static final double SQUARE_MM = 40;

    boolean contains(double x, double y) {
        boolean even = ((long) Math.floor(x / SQUARE_MM) + (long) Math.floor(y / SQUARE_MM)) % 2 == 0;
        return this == ALL || even == (this == FITTED);
    }
}
