package org.phrenic.engine.math;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RadixSortTest {
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 40, 41, 1000})
    void sortsAsTheLibraryDoes(int length) {
        Random random = new Random(length);
        for (int bits : new int[] {1, 12, 34, 64}) {
            long[] given = random.longs(length).toArray();
            assertSorted(Arrays.stream(given).map(k -> k >> (64 - bits)).toArray(), bits);
            // Without a sign the higher digits are equal in all keys, and are skipped.
            assertSorted(Arrays.stream(given).map(k -> k >>> (64 - bits)).toArray(), bits);
            assertSorted(
                    Arrays.stream(given).map(k -> k >>> (64 - bits) & -1L << 11).toArray(), bits);
        }
    }

    private static void assertSorted(long[] keys, int bits) {
        long[] expected = keys.clone();
        Arrays.sort(expected);
        RadixSort.sort(keys);
        assertThat(keys).as("keys of %d bits", bits).isEqualTo(expected);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 100})
    void whatLiesBehindTheLengthStays(int length) {
        long[] keys = new Random(1).longs(length + 2).toArray();
        long[] given = keys.clone();
        RadixSort.sort(keys, length);
        assertThat(keys[length]).isEqualTo(given[length]);
        assertThat(keys[length + 1]).isEqualTo(given[length + 1]);
        Arrays.sort(given, 0, length);
        assertThat(keys).isEqualTo(given);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 100})
    void aStretchIsSortedAndNothingElse(int length) {
        long[] keys = new Random(2).longs(length + 4).toArray();
        long[] expected = keys.clone();
        Arrays.sort(expected, 2, 2 + length);
        RadixSort.sort(keys, 2, 2 + length);
        assertThat(keys).isEqualTo(expected);
    }
}
