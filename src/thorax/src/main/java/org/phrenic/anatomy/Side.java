package org.phrenic.anatomy;

/** Side of the body. */
public enum Side {
    RIGHT,
    LEFT,
    MIDLINE;

    /** Sign of x in LPS: -1 right, +1 left, 0 midline. */
    public int sign() {
        return switch (this) {
            case RIGHT -> -1;
            case LEFT -> 1;
            case MIDLINE -> 0;
        };
    }
}
