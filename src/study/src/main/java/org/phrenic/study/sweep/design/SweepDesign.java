package org.phrenic.study.sweep.design;

/** A design of experiments: a reproducible sequence of points of the unit cube, one coordinate a factor. */
public interface SweepDesign {
    /**
     * The points.
     *
     * @return one row a point, one coordinate in [0, 1] a factor
     */
    double[][] points();
}
