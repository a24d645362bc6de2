package org.phrenic.access;

import java.util.Random;
import java.util.SplittableRandom;

/** Random numbers that a seed repeats. */
public final class SeededRandom {
    private SeededRandom() {}

    /**
     * A generator. Those of neighbouring seeds are independent: a seed is mixed first, for without that their first
     * numbers are alike.
     */
    public static Random of(long seed) {
        return new Random(new SplittableRandom(seed).nextLong());
    }
}
