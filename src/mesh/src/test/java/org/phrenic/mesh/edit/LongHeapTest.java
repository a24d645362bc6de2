package org.phrenic.mesh.edit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.PriorityQueue;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LongHeapTest {
    @Test
    void keysComeOutInOrderWhileOthersGoIn() {
        Random random = new Random(1);
        LongHeap heap = new LongHeap();
        PriorityQueue<Long> expected = new PriorityQueue<>();
        for (int i = 0; i < 20_000; i++) {
            if (random.nextInt(3) > 0 || expected.isEmpty()) {
                long key = random.nextInt(500) * (1L << 32) + random.nextInt();
                heap.add(key);
                expected.add(key);
            } else {
                assertThat(heap.poll()).isEqualTo(expected.poll());
            }
        }
        while (!expected.isEmpty()) {
            assertThat(heap.poll()).isEqualTo(expected.poll());
        }
        assertThat(heap.isEmpty()).isTrue();
    }
}
