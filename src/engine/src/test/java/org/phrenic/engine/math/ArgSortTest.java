package org.phrenic.engine.math;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Comparator;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ArgSortTest {
    @Test
    void isThatOfAStableSortOfTheirIndices() {
        Random random = new Random(5);
        for (int bound : new int[] {1, 3, 40, Integer.MAX_VALUE}) {
            long[] keys = IntStream.range(0, 500)
                    .mapToLong(i -> random.nextInt(bound) - bound / 2)
                    .toArray();
            int[] expected = IntStream.range(0, keys.length)
                    .boxed()
                    .sorted(Comparator.comparingLong(i -> keys[i]))
                    .mapToInt(i -> i)
                    .toArray();
            assertThat(ArgSort.of(keys)).isEqualTo(expected);
        }
        assertThat(ArgSort.of(new long[0])).isEmpty();
    }
}
