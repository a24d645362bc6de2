package org.phrenic.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class BoxesTest {
    private final double[] boxes = new double[12];

    @Test
    void aClearedBoxHoldsThePointsThatAreIncludedAndNoMore() {
        Boxes.clear(boxes, 6);
        Boxes.include(boxes, 6, new double[] {9, 1, -2, 3}, 1);
        Boxes.include(boxes, 6, new double[] {-1, 5, 0}, 0);
        assertThat(boxes).containsExactly(0, 0, 0, 0, 0, 0, -1, -2, 0, 1, 5, 3);
    }

    @Test
    void distanceIsThatOfTheNearestCornerEdgeOrFaceAndNothingInside() {
        Boxes.clear(boxes, 0);
        Boxes.include(boxes, 0, new double[] {0, 0, 0}, 0);
        Boxes.include(boxes, 0, new double[] {2, 4, 6}, 0);
        assertThat(Boxes.squaredDistance(boxes, 0, 1, 1, 1)).isZero();
        assertThat(Boxes.squaredDistance(boxes, 0, 1, 1, 9)).isEqualTo(9, within(0.0));
        assertThat(Boxes.squaredDistance(boxes, 0, -1, 1, 8)).isEqualTo(5, within(0.0));
        assertThat(Boxes.squaredDistance(boxes, 0, 5, 8, -1)).isEqualTo(26, within(0.0));
    }

    @Test
    void anEmptyBoxIsInfinitelyFar() {
        Boxes.clear(boxes, 0);
        assertThat(Boxes.squaredDistance(boxes, 0, 1, 2, 3)).isInfinite();
    }
}
