package org.phrenic.anatomy;

/** The side of the body a structure belongs to. */
public enum Side {
    RIGHT,
    LEFT,
    MIDLINE;

    /** {@code -1} right, {@code +1} left, {@code 0} midline: the sign of x in LPS. */
    public int sign() {
        return switch (this) {
            case RIGHT -> -1;
            case LEFT -> 1;
            case MIDLINE -> 0;
        };
    }
}
