package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.SphereMeshes;
import org.phrenic.mesh.TriangleMesh;

/** A ball of 50 mm about the origin and a plate that comes down on its top. */
class LiverIndentationTest {
    private static final double RADIUS_MM = 50;
    /**
     * A lattice of 8 mm sees a ball of 50 mm flatter than it is by h²/8r = 0.2 mm, and the plate's edge between its
     * nodes.
     */
    private static final double LATTICE_MM = 1.5;

    private final double[] step = new double[3];
    private LiverIndentation press;

    @BeforeEach
    void ball() {
        SphereMeshes.TriangleSurface ball = SphereMeshes.sphere(RADIUS_MM, 4);
        press = new LiverIndentation(new TriangleMesh(ball.positions(), ball.triangles()));
    }

    private boolean plateAt(double height) {
        press.clear();
        for (double x = -40; x <= 40; x += 4) {
            for (double y = -40; y <= 40; y += 4) {
                press.indent(x, y, height);
            }
        }
        return press.relax();
    }

    private double[] given(double x, double y, double z) {
        press.at(x, y, z, step);
        return step;
    }

    @Test
    void theTopGivesWayToThePlateAndTheFarSideStays() {
        assertThat(plateAt(RADIUS_MM - 10)).isTrue();
        assertThat(RADIUS_MM + given(0, 0, RADIUS_MM)[2]).isCloseTo(RADIUS_MM - 10, within(LATTICE_MM));
        assertThat(Math.abs(given(0, 0, -RADIUS_MM)[2])).isLessThan(0.1);
        assertThat(given(0, 0, RADIUS_MM - 24)[2])
                .as("what lies deeper goes along less")
                .isBetween(-6.0, -0.5);
    }

    @Test
    void whatOnlyTouchesPressesNothingIn() {
        assertThat(plateAt(RADIUS_MM + 1)).isFalse();
        assertThat(plateAt(RADIUS_MM - 0.5)).isFalse();
    }

    @Test
    void whatLayWithinAtRestMayStayThere() {
        press.allowRestDepth(0, 0, RADIUS_MM - 5);
        assertThat(plateAt(RADIUS_MM - 5)).isFalse();
        assertThat(plateAt(RADIUS_MM - 8)).isTrue();
    }

    @Test
    void theSameIsGivenAgainWhateverPressedBetween() {
        plateAt(RADIUS_MM - 10);
        double first = given(3, 4, RADIUS_MM - 2)[2];
        plateAt(RADIUS_MM - 20);
        plateAt(RADIUS_MM + 5);
        plateAt(RADIUS_MM - 10);
        assertThat(given(3, 4, RADIUS_MM - 2)[2]).isEqualTo(first);
    }
}
