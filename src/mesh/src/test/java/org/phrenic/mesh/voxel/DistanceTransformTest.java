package org.phrenic.mesh.voxel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class DistanceTransformTest {
    private static final int[] SIZE = {9, 7, 11};

    @Test
    void everyCellKnowsItsDistanceToTheNearestMarkedOne() {
        Random random = new Random(3);
        boolean[] marked = new boolean[SIZE[0] * SIZE[1] * SIZE[2]];
        for (int n = 0; n < 12; n++) {
            marked[random.nextInt(marked.length)] = true;
        }
        float[] distance = DistanceTransform.of(marked, SIZE);
        for (int a = 0; a < marked.length; a++) {
            double least = Double.POSITIVE_INFINITY;
            for (int b = 0; b < marked.length; b++) {
                int dx = a % SIZE[0] - b % SIZE[0];
                int dy = a / SIZE[0] % SIZE[1] - b / SIZE[0] % SIZE[1];
                int dz = a / SIZE[0] / SIZE[1] - b / SIZE[0] / SIZE[1];
                least = marked[b] ? Math.min(least, Math.sqrt(dx * dx + dy * dy + dz * dz)) : least;
            }
            assertThat((double) distance[a]).isCloseTo(least, within(1e-5));
        }
    }

    @Test
    void withoutAMarkedCellAllIsFarAway() {
        assertThat(DistanceTransform.of(new boolean[8], new int[] {2, 2, 2})[3]).isGreaterThan(1e9f);
        assertThatThrownBy(() -> DistanceTransform.of(new boolean[7], new int[] {2, 2, 2}))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
