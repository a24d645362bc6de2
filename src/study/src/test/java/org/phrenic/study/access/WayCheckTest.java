package org.phrenic.study.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Segments and a triangle in the plane z = 0 with corners (0, 0), (4, 0), (0, 4). */
class WayCheckTest {
    private static final double[] CORNERS = {0, 0, 0, 4, 0, 0, 0, 4, 0};

    private static boolean isCrossed(double... path) {
        return WayCheck.isCrossed(path, CORNERS, 0, 3, 6);
    }

    @Test
    void aWayCrossesWhatLiesBetweenItsEnds() {
        assertThat(isCrossed(1, 1, 5, 1, 1, -5)).isTrue();
        assertThat(isCrossed(1, 1, -5, 1, 1, 5)).as("from below").isTrue();
        assertThat(isCrossed(1, 1, 5, 1, 1, 1)).as("ends above").isFalse();
        assertThat(isCrossed(3, 3, 5, 3, 3, -5)).as("passes beside").isFalse();
        assertThat(isCrossed(-1, 1, 5, 3, 1, -5)).as("oblique").isTrue();
        assertThat(isCrossed(0, 0, 1, 0, 0, -1)).as("through a corner").isTrue();
    }

    /** Where a random segment meets the plane says the same, away from the edges. */
    @Test
    void theSameAsThePointInThePlane() {
        Random random = new Random(1);
        int inside = 0;
        for (int i = 0; i < 20_000; i++) {
            double[] path = random.doubles(6, -6, 6).toArray();
            double s = path[2] / (path[2] - path[5]);
            double x = path[0] + s * (path[3] - path[0]);
            double y = path[1] + s * (path[4] - path[1]);
            boolean expected = s >= 0 && s <= 1 && x >= 0 && y >= 0 && x + y <= 4;
            assertThat(isCrossed(path)).isEqualTo(expected);
            inside += expected ? 1 : 0;
        }
        assertThat(inside).isGreaterThan(500);
    }
}
