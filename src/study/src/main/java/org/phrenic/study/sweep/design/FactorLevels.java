package org.phrenic.study.sweep.design;

/**
 * The levels of a factor in a design that has some.
 *
 * @param count number of levels, at least 1
 * @param spacing where they lie
 */
public record FactorLevels(int count, Spacing spacing) {
    /** Where the levels of a factor lie in its range of coordinates, 0 to 1. */
    public enum Spacing {
        /** Equally spaced, with both ends. */
        ENDS,
        /** Middles of equal intervals, for a distribution whose ends are out of reach. */
        MIDDLES,
        /** Middles of equal intervals, each of which stands for a listed value. */
        LISTED
    }

    /** Coordinate of a level, counted from 0. */
    double coordinate(int level) {
        return spacing == Spacing.ENDS && count > 1 ? (double) level / (count - 1) : (level + 0.5) / count;
    }
}
