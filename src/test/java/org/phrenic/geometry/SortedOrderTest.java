package org.phrenic.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Comparator;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class SortedOrderTest {
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
            assertThat(SortedOrder.of(keys)).isEqualTo(expected);
        }
        assertThat(SortedOrder.of(new long[0])).isEmpty();
    }
}
