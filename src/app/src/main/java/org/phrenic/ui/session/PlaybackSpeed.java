package org.phrenic.ui.session;

/** Speeds of simulated time over real time. */
public enum PlaybackSpeed {
    QUARTER("0.25x", 0.25),
    HALF("0.5x", 0.5),
    REAL("1x real time", 1),
    DOUBLE("2x", 2),
    FLAT_OUT("Flat out", Double.POSITIVE_INFINITY);

    private final String label;
    private final double factor;

    PlaybackSpeed(String label, double factor) {
        this.label = label;
        this.factor = factor;
    }

    public double factor() {
        return factor;
    }

    @Override
    public String toString() {
        return label;
    }
}
