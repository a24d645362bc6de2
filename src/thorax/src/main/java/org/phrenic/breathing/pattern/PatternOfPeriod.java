package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathingPattern;

/** A pattern with a stated period. */
abstract class PatternOfPeriod implements BreathingPattern {
    private final double periodS;

    /** @param periodS period, s; infinite for a pattern that does not repeat */
    PatternOfPeriod(double periodS) {
        this.periodS = periodS;
    }

    @Override
    public final double periodS() {
        return periodS;
    }
}
