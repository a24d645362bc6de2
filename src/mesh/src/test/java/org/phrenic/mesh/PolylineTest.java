package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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

    @Test
    void aPointWithoutAllCoordinatesIsRefused() {
        assertThatThrownBy(() -> Polyline.of(new double[7]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("polyline: found 7 coordinates, expected three for each point");
    }
}
