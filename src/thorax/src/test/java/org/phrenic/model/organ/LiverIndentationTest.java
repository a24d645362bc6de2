package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

    /** At the ends of the ellipsoid, whose radii of curvature are 32 mm at least. */
    private static final double POINTED_MM = 2;

    private static final double[] HALF_MM = {60, 52, 44};

    private final double[] step = new double[3];
    private LiverIndentation press;

    @BeforeEach
    void ball() {
        SphereMeshes.TriangleSurface ball = SphereMeshes.sphere(RADIUS_MM, 4);
        press = new LiverIndentation(new TriangleMesh(ball.positions(), ball.triangles()));
    }

    /** An ellipsoid about the origin with the half axes {@link #HALF_MM}. */
    private static LiverIndentation ellipsoid() {
        SphereMeshes.TriangleSurface ball = SphereMeshes.sphere(1, 4);
        double[] p = ball.positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] *= HALF_MM[i % 3];
        }
        return new LiverIndentation(new TriangleMesh(p, ball.triangles()));
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

    @ParameterizedTest
    @CsvSource({"0, 1", "0, -1", "1, 1", "1, -1", "2, 1", "2, -1"})
    void anOrganOfThreeLengthsGivesWayAlongThePushFromAnySide(int axis, int side) {
        press = ellipsoid();
        double[] p = new double[3];
        p[axis] = side * (HALF_MM[axis] - 10);
        for (double u = -32; u <= 32; u += 4) {
            for (double v = -32; v <= 32; v += 4) {
                p[(axis + 1) % 3] = u;
                p[(axis + 2) % 3] = v;
                press.indent(p[0], p[1], p[2]);
            }
        }
        assertThat(press.relax()).isTrue();
        double[] end = new double[3];
        end[axis] = side * HALF_MM[axis];
        double[] wanted = new double[3];
        wanted[axis] = -10 * side;
        assertThat(given(end[0], end[1], end[2])).containsExactly(wanted, within(POINTED_MM));
    }

    /** Each point is pushed in alone, so that only the nodes about it are asked to move. */
    @ParameterizedTest
    @CsvSource({"0, 1", "0, -1", "1, 1", "1, -1", "2, 1", "2, -1"})
    void aPointOfAnOrganOfThreeLengthsPushesInWhatIsAboutIt(int axis, int side) {
        press = ellipsoid();
        double[] p = new double[3];
        p[axis] = side * (HALF_MM[axis] - 10);
        press.indent(p[0], p[1], p[2]);
        assertThat(press.relax()).isTrue();
        p[axis] = side * HALF_MM[axis];
        double[] dent = given(p[0], p[1], p[2]).clone();
        assertThat(-side * dent[axis]).isBetween(1.0, 10.0);
        for (int other = 1; other < 3; other++) {
            assertThat(dent[(axis + other) % 3]).isCloseTo(0, within(0.1 * Math.abs(dent[axis])));
        }
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
