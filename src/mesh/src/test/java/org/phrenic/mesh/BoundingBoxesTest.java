package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class BoundingBoxesTest {
    private final double[] boxes = new double[12];

    @Test
    void aClearedBoxHoldsThePointsThatAreIncludedAndNoMore() {
        BoundingBoxes.setEmpty(boxes, 6);
        BoundingBoxes.include(boxes, 6, new double[] {9, 1, -2, 3}, 1);
        BoundingBoxes.include(boxes, 6, new double[] {-1, 5, 0}, 0);
        assertThat(boxes).containsExactly(0, 0, 0, 0, 0, 0, -1, -2, 0, 1, 5, 3);
    }

    @Test
    void theBoxAroundARunOfPointsHoldsThemAndNoOther() {
        double[] points = {-9, 9, 9, 1, -2, 3, -1, 5, 0, 99, -99, 99};
        BoundingBoxes.around(points, 3, 9, boxes, 6);
        assertThat(boxes).containsExactly(0, 0, 0, 0, 0, 0, -1, -2, 0, 1, 5, 3);
        BoundingBoxes.around(points, 3, 3, boxes, 6);
        assertThat(BoundingBoxes.squaredDistance(boxes, 6, 1, 2, 3)).isInfinite();
    }

    @Test
    void distanceIsThatOfTheNearestCornerEdgeOrFaceAndNothingInside() {
        BoundingBoxes.setEmpty(boxes, 0);
        BoundingBoxes.include(boxes, 0, new double[] {0, 0, 0}, 0);
        BoundingBoxes.include(boxes, 0, new double[] {2, 4, 6}, 0);
        assertThat(BoundingBoxes.squaredDistance(boxes, 0, 1, 1, 1)).isZero();
        assertThat(BoundingBoxes.squaredDistance(boxes, 0, 1, 1, 9)).isEqualTo(9, within(0.0));
        assertThat(BoundingBoxes.squaredDistance(boxes, 0, -1, 1, 8)).isEqualTo(5, within(0.0));
        assertThat(BoundingBoxes.squaredDistance(boxes, 0, 5, 8, -1)).isEqualTo(26, within(0.0));
    }

    @Test
    void anEmptyBoxIsInfinitelyFar() {
        BoundingBoxes.setEmpty(boxes, 0);
        assertThat(BoundingBoxes.squaredDistance(boxes, 0, 1, 2, 3)).isInfinite();
    }
}
