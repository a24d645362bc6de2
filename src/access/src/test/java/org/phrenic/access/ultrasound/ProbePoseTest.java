package org.phrenic.access.ultrasound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

class ProbePoseTest {
    private static final double[] FRONT = {0, -1, 0};
    private static final Offset<Double> ROUNDING = within(1e-12);

    private static ProbePose front(double rotation, double tilt, double rock) {
        return ProbePose.onSkin(new double[] {1, 2, 3}, FRONT, new ProbePose.Angles(rotation, tilt, rock), 0);
    }

    @Test
    void markerPointsToTheHeadAndAfterARightAngleToThePatientsRight() {
        assertThat(front(0, 0, 0).lateral()).containsExactly(new double[] {0, 0, 1}, ROUNDING);
        assertThat(front(90, 0, 0).lateral()).containsExactly(new double[] {-1, 0, 0}, ROUNDING);
        assertThat(front(0, 0, 0).axial()).containsExactly(new double[] {0, 1, 0}, ROUNDING);
    }

    @Test
    void tiltSweepsThePlaneAndRockTurnsWithinIt() {
        double[] tilted = front(90, 30, 0).axial();
        assertThat(tilted).containsExactly(new double[] {0, Math.sqrt(0.75), 0.5}, ROUNDING);
        assertThat(front(90, 30, 0).lateral()).containsExactly(new double[] {-1, 0, 0}, ROUNDING);
        ProbePose rocked = front(0, 0, 30);
        assertThat(rocked.axial()).containsExactly(new double[] {0, Math.sqrt(0.75), 0.5}, ROUNDING);
        assertThat(rocked.elevation()).containsExactly(front(0, 0, 0).elevation(), ROUNDING);
    }

    @Test
    void probeCoordinatesAndBack() {
        ProbePose pose = front(25, -12, 7);
        double[] there = pose.toProbe(pose.toWorld(4, 5, 6));
        assertThat(there).containsExactly(new double[] {4, 5, 6}, ROUNDING);
    }

    private static List<Surface> roundSkin() {
        return List.of(new Surface(
                "skin",
                StructureKind.SKIN,
                0,
                Side.MIDLINE,
                Shapes.sphere(100, 4),
                Surface.Motion.STILL,
                new boolean[0]));
    }

    /** A needle that enters there and points along the plane stays in it. */
    @ParameterizedTest
    @CsvSource({"0, 0", "20, 0", "-35, 25", "60, 0"})
    void theSkinBesideATiltedProbeIsInItsImagePlane(double tiltDeg, double rockDeg) {
        List<Surface> surfaces = roundSkin();
        ScannedSkin skin = new ScannedSkin(surfaces);
        double[] place = skin.nearestPoint(new double[] {0, -100, 0});
        ProbeOnSkin probe = skin.at(place);
        Frame frame = Frame.still(surfaces);
        ProbePose held = probe.pose(frame, new ProbePose.Angles(30, tiltDeg, rockDeg));
        double[] at = skin.inImagePlane(held, probe.pose(frame, new ProbePose.Angles(30, 0, 0)), place, 42);
        assertThat(held.toProbe(at)[2]).as("mm out of the plane").isCloseTo(0, within(0.1));
        assertThat(held.toProbe(at)[0]).as("mm toward the marker").isGreaterThan(30);
        assertThat(Vectors.distance(at, skin.nearestPoint(at))).isLessThan(1e-6);
    }

    @Test
    void probeOnSkinIsPressedInAndAPlaceOffTheSkinIsRefused() {
        List<Surface> surfaces = roundSkin();
        ProbePose pose =
                new ProbeOnSkin(surfaces, new double[] {0, -100, 0}).pose(Frame.still(surfaces), ProbePose.Angles.ZERO);
        assertThat(pose.face()[1]).isCloseTo(ProbeOnSkin.PRESS_MM - 100, within(0.5));
        assertThat(pose.axial()[1]).isGreaterThan(0.999);
        assertThatThrownBy(() -> new ProbeOnSkin(surfaces, new double[] {0, -130, 0}))
                .hasMessageContaining("30.0 mm off the skin");
        assertThatThrownBy(() -> new ProbeOnSkin(List.of(), new double[3])).hasMessageContaining("found no skin");
    }
}
