package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathingPattern;

/** A pattern with a name and a period. */
abstract class NamedPattern implements BreathingPattern {
    private final String name;
    private final double periodS;

    /** @param periodS period, s; infinite for a pattern that does not repeat */
    NamedPattern(String name, double periodS) {
        this.name = name;
        this.periodS = periodS;
    }

    @Override
    public final String name() {
        return name;
    }

    @Override
    public final double periodS() {
        return periodS;
    }
}
