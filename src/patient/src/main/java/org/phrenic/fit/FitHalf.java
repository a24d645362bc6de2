package org.phrenic.fit;

/** Which of a surface counts: all, or one of two halves that lie like the squares of a chessboard seen from above. */
public enum FitHalf {
    ALL,
    /** The half that is fitted to where the other is held out. */
    FITTED,
    HELD_OUT;

    /** Side of a square, mm: several times the edge of any mesh, a few of them on a dome. */
    private static final double SQUARE_MM = 40;

    /** Whether a place counts. */
    boolean contains(double x, double y) {
        boolean even = ((long) Math.floor(x / SQUARE_MM) + (long) Math.floor(y / SQUARE_MM)) % 2 == 0;
        return this == ALL || even == (this == FITTED);
    }
}
