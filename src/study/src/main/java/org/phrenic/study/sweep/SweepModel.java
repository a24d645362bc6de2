package org.phrenic.study.sweep;

import java.util.List;

/** What a study evaluates: a function from a point of the design to responses. May be used by several threads. */
public interface SweepModel {
    /** Names of the responses. */
    List<String> responses();

    /** How many of the responses are analysed; the others make a map of directions. */
    default int analysed() {
        return responses().size();
    }

    /** Names of the time series that each run records; may be empty. */
    List<String> series();

    /**
     * Least and greatest value of a factor that is a number.
     *
     * @return two numbers; none for a factor that takes listed values only
     * @throws IllegalArgumentException with one sentence, if there is no such factor
     */
    double[] limits(String key);

    /**
     * Checks a value of a factor.
     *
     * @throws IllegalArgumentException with one sentence, if there is no such factor or it cannot take the value
     */
    void check(String key, String value);

    /** Names of the columns that {@link #traits} describes. */
    default List<String> traitNames() {
        return List.of();
    }

    /** What follows from a point before it is computed, such as the size of a body. */
    default List<String> traits(SweepPoint point) {
        return List.of();
    }

    /**
     * Evaluates a point. The same point gives the same bits.
     *
     * @throws RuntimeException if there is no result; its message becomes the reason in the table of runs
     */
    SweepOutcome evaluate(SweepPoint point);
}
