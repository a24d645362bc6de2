package org.phrenic.scene.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What a camera must do whoever turns it: nothing mirrored, nothing lost, the cursor keeps what it points at. */
class CameraTest {
    private static final double PIXEL = 1e-6;
    private static final double MM = 1e-9;
    private static final double UNIT = 1e-12;

    /** A body about as large as a torso, off the origin. */
    private static final double[] BODY = {-180, -120, 900, 190, 110, 1450};

    private static Camera camera(double azimuth, double elevation, boolean parallel) {
        return Camera.of(AnatomicalView.ANTERIOR, BODY)
                .orbit(azimuth, elevation)
                .withProjection(parallel);
    }

    @ParameterizedTest
    @EnumSource(AnatomicalView.class)
    void aCameraHasAStandardViewUntilItIsTurned(AnatomicalView view) {
        Camera camera = camera(-52, 6, false).withView(view);
        assertThat(camera.view()).contains(view);
        assertThat(camera.pan(30, 20, 480).zoom(2, 10, 10, 640, 480).view()).contains(view);
        assertThat(camera.orbit(360, 0).view()).contains(view);
        assertThat(camera.orbit(0.4, 0).view()).isEmpty();
    }

    @Property(seed = "1")
    void aPointOnTheRayOfAPixelIsSeenInThatPixel(
            @ForAll @DoubleRange(min = -720, max = 720) double azimuth,
            @ForAll @DoubleRange(min = -90, max = 90) double elevation,
            @ForAll boolean parallel,
            @ForAll @DoubleRange(min = 0, max = 640) double px,
            @ForAll @DoubleRange(min = 0, max = 480) double py,
            @ForAll @DoubleRange(min = 0, max = 900) double along) {
        Camera camera = camera(azimuth, elevation, parallel);
        double[] ray = camera.ray(px, py, 640, 480);
        double[] xy = new double[2];
        assertThat(camera.project(
                        ray[0] + along * ray[3], ray[1] + along * ray[4], ray[2] + along * ray[5], 640, 480, xy))
                .isTrue();
        assertThat(xy[0]).isCloseTo(px, within(PIXEL));
        assertThat(xy[1]).isCloseTo(py, within(PIXEL));
        assertThat(Math.hypot(Math.hypot(ray[3], ray[4]), ray[5])).isCloseTo(1, within(UNIT));
    }

    @Property(seed = "1")
    void matricesPutAPointWhereProjectDoes(
            @ForAll @DoubleRange(min = -180, max = 180) double azimuth,
            @ForAll @DoubleRange(min = -90, max = 90) double elevation,
            @ForAll boolean parallel,
            @ForAll @DoubleRange(min = -150, max = 150) double x,
            @ForAll @DoubleRange(min = -100, max = 100) double y,
            @ForAll @DoubleRange(min = 950, max = 1400) double z) {
        Camera camera = camera(azimuth, elevation, parallel);
        Vector4d clip = camera.projectionMatrix(1.5).mul(camera.viewMatrix()).transform(new Vector4d(x, y, z, 1));
        double[] xy = new double[2];
        camera.project(x, y, z, 900, 600, xy);
        assertThat((clip.x / clip.w + 1) * 450).isCloseTo(xy[0], within(0.01));
        assertThat((1 - clip.y / clip.w) * 300).isCloseTo(xy[1], within(0.01));
        assertThat(clip.z / clip.w).as("depth of what is in the body").isBetween(-1.0, 1.0);
    }

    @Property(seed = "1")
    void noDirectionMirrorsTheBody(
            @ForAll @DoubleRange(min = -720, max = 720) double azimuth,
            @ForAll @DoubleRange(min = -200, max = 200) double elevation) {
        Camera camera = camera(azimuth, elevation, false);
        Matrix4d m = camera.viewMatrix();
        assertThat(m.determinant3x3()).isCloseTo(1, within(1e-6));
        assertThat(camera.up().z).as("superior stays up").isGreaterThanOrEqualTo(0);
        Matrix4d p = camera.projectionMatrix(1);
        assertThat(p.m00()).isPositive();
        assertThat(p.m11()).isPositive();
    }

    @Property(seed = "1")
    void zoomKeepsWhatTheCursorPointsAt(
            @ForAll @DoubleRange(min = -180, max = 180) double azimuth,
            @ForAll @DoubleRange(min = -90, max = 90) double elevation,
            @ForAll boolean parallel,
            @ForAll @DoubleRange(min = 0.2, max = 8) double factor,
            @ForAll @IntRange(min = 0, max = 640) int px,
            @ForAll @IntRange(min = 0, max = 480) int py) {
        Camera before = camera(azimuth, elevation, parallel);
        double[] ray = before.ray(px, py, 640, 480);
        Vector3d d = before.towardsViewer();
        double toPlane =
                before.target().sub(ray[0], ray[1], ray[2], new Vector3d()).dot(d) / d.dot(ray[3], ray[4], ray[5]);
        double[] xy = new double[2];
        Camera after = before.zoom(factor, px, py, 640, 480);
        after.project(ray[0] + toPlane * ray[3], ray[1] + toPlane * ray[4], ray[2] + toPlane * ray[5], 640, 480, xy);
        assertThat(xy[0]).isCloseTo(px, within(PIXEL));
        assertThat(xy[1]).isCloseTo(py, within(PIXEL));
        assertThat(after.mmPerPixel(480) * factor).isCloseTo(before.mmPerPixel(480), within(MM));
    }

    @Property(seed = "1")
    void panMovesTheTargetPlaneWithTheCursor(
            @ForAll @DoubleRange(min = -180, max = 180) double azimuth,
            @ForAll @DoubleRange(min = -300, max = 300) double dx,
            @ForAll @DoubleRange(min = -300, max = 300) double dy) {
        Camera before = camera(azimuth, 20, false);
        double[] xy = new double[2];
        Vector3dc target = before.target();
        before.pan(dx, dy, 480).project(target.x(), target.y(), target.z(), 640, 480, xy);
        assertThat(xy[0]).isCloseTo(320 + dx, within(PIXEL));
        assertThat(xy[1]).isCloseTo(240 + dy, within(PIXEL));
    }

    @Test
    void aFullTurnReturns() {
        Camera start = Camera.of(AnatomicalView.ANTERIOR, BODY);
        Camera turned = start;
        for (int i = 0; i < 36; i++) {
            turned = turned.orbit(10, 0);
        }
        assertThat(turned).isEqualTo(start);
    }

    @Test
    void thePolesAreTheEndOfTheTurntable() {
        Camera top = Camera.of(AnatomicalView.ANTERIOR, BODY).orbit(0, 500);
        assertThat(top.elevationDeg()).isEqualTo(90);
        assertThat(top.right().x).isCloseTo(1, within(UNIT));
        assertThat(top.up().y).as("from above the front is at the bottom").isCloseTo(1, within(UNIT));
    }

    @Test
    void bothProjectionsShowTheSameExtentAtTheTarget() {
        Camera perspective = Camera.of(AnatomicalView.LEFT, BODY);
        Camera parallel = perspective.withProjection(true);
        Vector3d at = new Vector3d(perspective.target()).fma(50, perspective.up());
        double[] one = new double[2];
        double[] other = new double[2];
        perspective.project(at.x, at.y, at.z, 640, 480, one);
        parallel.project(at.x, at.y, at.z, 640, 480, other);
        assertThat(one[1]).isCloseTo(other[1], within(PIXEL));
        double height = 240 - one[1];
        assertThat(50 / perspective.mmPerPixel(480)).isCloseTo(height, within(PIXEL));
        // Nearer to the viewer a perspective picture is larger, a parallel one is not.
        at.fma(200, perspective.towardsViewer());
        perspective.project(at.x, at.y, at.z, 640, 480, one);
        parallel.project(at.x, at.y, at.z, 640, 480, other);
        assertThat(240 - other[1]).isCloseTo(height, within(PIXEL));
        assertThat(240 - one[1]).isGreaterThan(height + 5);
    }

    @Test
    void aPictureHasTheProjectionThatIsAskedFor() {
        PictureSettings perspective = PictureSettings.of(AnatomicalView.LEFT, 64, 64, "");
        assertThat(perspective.camera(BODY).orthographic()).isFalse();
        PictureSettings parallel = new PictureSettings(AnatomicalView.LEFT, 64, 64, true, 1, true, "");
        assertThat(parallel.camera(BODY).orthographic()).isTrue();
    }

    @ParameterizedTest
    @EnumSource(AnatomicalView.class)
    void aStandardViewHoldsAllOfTheBody(AnatomicalView view) {
        for (double aspect : new double[] {0.5, 1, 2}) {
            Camera camera = Camera.of(view, BODY, aspect);
            double[] xy = new double[2];
            for (int corner = 0; corner < 8; corner++) {
                camera.project(
                        BODY[(corner & 1) * 3],
                        BODY[1 + (corner >> 1 & 1) * 3],
                        BODY[2 + (corner >> 2 & 1) * 3],
                        (int) (800 * aspect),
                        800,
                        xy);
                assertThat(xy[0]).isBetween(0.0, 800 * aspect);
                assertThat(xy[1]).isBetween(0.0, 800.0);
            }
        }
    }

    /** What is at the right of the picture and at its top, as an anatomist expects of each view. */
    @ParameterizedTest
    @EnumSource(AnatomicalView.class)
    void eachViewShowsTheRightSides(AnatomicalView view) {
        Camera camera = Camera.of(view, BODY);
        double[] rightward =
                switch (view) {
                    case ANTERIOR, SUPERIOR, INFERIOR -> new double[] {1, 0, 0};
                    case POSTERIOR -> new double[] {-1, 0, 0};
                    case LEFT -> new double[] {0, 1, 0};
                    case RIGHT -> new double[] {0, -1, 0};
                };
        double[] upward =
                switch (view) {
                    case SUPERIOR -> new double[] {0, 1, 0};
                    case INFERIOR -> new double[] {0, -1, 0};
                    default -> new double[] {0, 0, 1};
                };
        for (int i = 0; i < 3; i++) {
            assertThat(camera.right().get(i)).isCloseTo(rightward[i], within(UNIT));
            assertThat(camera.up().get(i)).isCloseTo(upward[i], within(UNIT));
        }
    }

    @Test
    void aPointBehindTheEyeIsNotSeen() {
        Camera camera = Camera.of(AnatomicalView.ANTERIOR, BODY);
        Vector3d eye = camera.eye();
        double[] xy = {7, 7};
        assertThat(camera.project(eye.x, eye.y - 10, eye.z, 640, 480, xy)).isFalse();
        assertThat(xy).containsExactly(7, 7);
    }

    @Test
    void anEmptySceneHasACameraToo() {
        double[] none = {
            Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY
        };
        for (double number :
                Camera.of(AnatomicalView.LEFT, none).projectionMatrix(1).get(new double[16])) {
            assertThat(number).isFinite();
        }
    }
}
