package org.phrenic.access;

import java.util.Random;
import java.util.SplittableRandom;

/** Random numbers that a seed repeats. */
public final class SeededRandom {
    private SeededRandom() {}

    /**
     * A generator whose seed is mixed first: {@link Random} gives nearly equal first numbers for neighbouring seeds.
     */
    public static Random of(long seed) {
        return new Random(new SplittableRandom(seed).nextLong());
    }
}
