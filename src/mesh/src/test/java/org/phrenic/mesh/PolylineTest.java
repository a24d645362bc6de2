package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class PolylineTest {
    /** Points that are listed twice, at the ends too, as where a course is closed or two pieces meet. */
    @Test
    void aPointListedTwiceAddsNothing() {
        Polyline line = Polyline.of(new double[] {0, 0, 0, 0, 0, 0, 10, 0, 0, 10, 0, 0, 10, 20, 0, 10, 20, -0.0});
        assertThat(line.length()).isEqualTo(30);
        assertThat(line.pointAt(-1)).containsExactly(-1, 0, 0);
        assertThat(line.pointAt(10)).containsExactly(10, 0, 0);
        assertThat(line.pointAt(30)).containsExactly(10, 20, 0);
        assertThat(line.pointAt(31)).containsExactly(10, 21, 0);
        assertThat(line.direction(29)).containsExactly(0, 1, 0);
        assertThat(line.direction(1)).containsExactly(1, 0, 0);
    }

    /**
     * Knots at 0, 4 and 7 mm with the slopes (1, 0), (4, 3) / 7 and (0, 1). A third of the way to the middle one the
     * weights are 7/27 of its place, 16/27 of the first slope and -8/27 of the second.
     */
    @Test
    void aSplineHasTheMeanSlopeOfTheSpansAboutAKnot() {
        Polyline spline =
                Polyline.catmullRom(List.of(new double[] {0, 0, 0}, new double[] {4, 0, 0}, new double[] {4, 3, 0}), 3);
        double[] third = {92 / 63.0, -8 / 63.0, 0};
        assertThat(spline.pointAt(Math.hypot(third[0], third[1]))).containsExactly(third, within(1e-12));
        assertThat(spline.first()).containsExactly(0, 0, 0);
        assertThat(spline.last()).containsExactly(4, 3, 0);
    }

    @Test
    void aPartIsResampledAtEqualSteps() {
        Polyline part = Polyline.of(new double[] {0, 0, 0, 10, 0, 0, 10, 20, 0}).resample(2, 26, 4);
        assertThat(part.first()).containsExactly(2, 0, 0);
        assertThat(part.last()).containsExactly(10, 16, 0);
        // Steps of 8 mm: the first ends at the corner.
        assertThat(part.length()).isCloseTo(24, within(1e-12));
        assertThat(part.pointAt(16)).containsExactly(new double[] {10, 8, 0}, within(1e-12));
    }

    @Test
    void aPointWithoutAllCoordinatesIsRefused() {
        assertThatThrownBy(() -> Polyline.of(new double[7]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("polyline: found 7 coordinates, expected three for each point");
    }
}
