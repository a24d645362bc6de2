package org.phrenic.access.ultrasound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.access.Needle;

class SonatedNeedleTest {
    private static final double DEPTH = 81;
    private static final double WIDTH = CurvilinearProbe.abdominal().elevationWidthMm(DEPTH);

    private static double amplitude(double elevation, double riseDeg) {
        BModeImage image = new SonatedScene().image(SonatedScene.needleAcross(DEPTH, elevation, riseDeg));
        double most = 0;
        for (double d = DEPTH - 3; d < DEPTH + 3; d += 0.3) {
            most = Math.max(most, image.intensity(SonatedScene.CENTRAL_LINE, d));
        }
        return Math.sqrt(most);
    }

    /** Steel in soft tissue reflects 0.93; a needle of 1.2 mm covers its share of the beam's thickness. */
    @Test
    void needleIsSeenExactlyWhereItLiesInTheBeam() {
        double full = amplitude(0, 0);
        assertThat(full / (0.93 * 1.2 / WIDTH)).isCloseTo(1, within(0.02));
        assertThat(amplitude(0.5 * WIDTH, 0) / full).isCloseTo(0.5, within(0.01));
        assertThat(amplitude(-0.98 * WIDTH, 0)).isPositive().isLessThan(0.01 * full);
        double empty = Math.sqrt(new SonatedScene().image().intensity(SonatedScene.CENTRAL_LINE, DEPTH));
        assertThat(amplitude(1.02 * WIDTH, 0)).isLessThan(1e-6 * full);
        assertThat(amplitude(-1.02 * WIDTH, 0)).isLessThan(1e-6 * full);
        assertThat(empty).isLessThan(1e-6 * full);
    }

    @Test
    void needleIsBrightestAtARightAngleToTheBeam() {
        double across = amplitude(0, 0);
        double oblique = amplitude(0, 30);
        double steep = amplitude(0, 60);
        assertThat(oblique).isLessThan(Math.pow(Math.cos(Math.toRadians(30)), 3) * across);
        assertThat(steep).isLessThan(0.3 * oblique).isPositive();
    }

    @Test
    void needleBehindARibIsNotSeen() {
        SonatedScene scene = new SonatedScene().with("rib_08_R", org.phrenic.anatomy.StructureKind.RIB, 15, 45);
        BModeImage with = scene.image(SonatedScene.needleAcross(DEPTH, 0, 0));
        BModeImage without = scene.image();
        assertThat(with.grey()).isEqualTo(without.grey());
    }

    /** A needle that goes through the image plane at 45 degrees is in it for sqrt(2) times the thickness. */
    @Test
    void lengthInBeamIsThatWithinItsThickness() {
        CurvilinearProbe probe = CurvilinearProbe.abdominal();
        SonatedNeedle through =
                new SonatedNeedle(new double[] {DEPTH, -20, -20}, new double[] {DEPTH, 20, 20}, Needle.standard());
        assertThat(through.lengthInBeamMm(probe, SonatedScene.POSE, 150)).isCloseTo(Math.sqrt(2) * WIDTH, within(0.3));
        assertThat(through.isTipInBeam(probe, SonatedScene.POSE, 150)).isFalse();
        SonatedNeedle along = SonatedScene.needleAcross(DEPTH, 0, 0);
        assertThat(along.lengthInBeamMm(probe, SonatedScene.POSE, 150)).isCloseTo(40, within(0.3));
        assertThat(along.lengthInBeamMm(probe, SonatedScene.POSE, 80)).isZero();
        assertThat(along.isTipInBeam(probe, SonatedScene.POSE, 150)).isTrue();
    }
}
