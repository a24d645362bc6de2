package org.phrenic.access.ultrasound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.access.imaging.Tissue;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Images of plane tissues before a probe in water, against closed forms. */
class UltrasoundTest {
    private static final int MIDDLE = SonatedScene.CENTRAL_LINE;

    /** Water has 1.46 MRayl and attenuates by 0.0022 dB/cm at 1 MHz: 6 cm there and back at 3.5 MHz. */
    @ParameterizedTest
    @CsvSource({"aorta, VESSEL, 1.61", "rib_08_R, RIB, 6.50", "lung_R, LUNG, 0.26", "psoas, MUSCLE, 1.68"})
    void halfSpaceReflectsByItsImpedance(String name, StructureKind kind, double impedance) {
        BModeImage image = new SonatedScene().with(name, kind, 60, 190).image();
        double reflection = Math.abs(impedance - 1.46) / (impedance + 1.46);
        double kept = Math.pow(10, -0.0022 * 3.5 * 2 * 6 / 20);
        assertThat(Math.sqrt(image.intensity(MIDDLE, 60)) / (reflection * kept)).isCloseTo(1, within(0.01));
    }

    /** Muscle: 0.96 dB/cm at 1 MHz, 1.68 MRayl. Bone behind it returns less, by that and by what both faces reflect. */
    @ParameterizedTest
    @ValueSource(doubles = {6, 15, 30})
    void slabAttenuatesByItsThickness(double thickness) {
        SonatedScene bone = new SonatedScene().with("rib_08_R", StructureKind.RIB, 90, 190);
        double free = bone.image().intensity(MIDDLE, 90);
        double behind = bone.with("psoas", StructureKind.MUSCLE, 45, 45 + thickness)
                .image()
                .intensity(MIDDLE, 90);
        double face = (1.68 - 1.46) / (1.68 + 1.46);
        double expected = Math.pow(1 - face * face, 2) * Math.pow(10, -(0.96 - 0.0022) * 3.5 * 2 * thickness / 200);
        assertThat(Math.sqrt(behind / free) / expected).isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"rib_08_R, RIB", "sternum, STERNUM", "vertebra_L1, VERTEBRA"})
    void boneCastsAShadow(String name, StructureKind kind) {
        BModeImage image = new SonatedScene()
                .with("skin", StructureKind.SKIN, -10, 190)
                .with(name, kind, Surface.Motion.STILL, 15, -6, 21, 6)
                .image();
        double shadow = SonatedScene.mean(image, MIDDLE - 8, MIDDLE + 8, 50, 90);
        double beside = SonatedScene.mean(image, MIDDLE + 60, MIDDLE + 76, 50, 90);
        assertThat(SonatedScene.db(beside / shadow)).isGreaterThan(30);
    }

    @ParameterizedTest
    @ValueSource(strings = {"gallbladder", "kidney_cyst_R", "urinary_bladder"})
    void behindFluidTissueIsBrighterByTheAttenuationThatIsMissing(String name) {
        BModeImage image = new SonatedScene()
                .with("liver", StructureKind.LIVER, -10, 190)
                .with(name, StructureKind.ORGAN, Surface.Motion.STILL, 40, -20, 70, 20)
                .image();
        double inside = SonatedScene.mean(image, MIDDLE - 15, MIDDLE + 15, 45, 65);
        double behind = SonatedScene.mean(image, MIDDLE - 15, MIDDLE + 15, 75, 110);
        double beside = SonatedScene.mean(image, MIDDLE + 80, MIDDLE + 110, 75, 110);
        assertThat(SonatedScene.db(beside / inside)).as("fluid is dark").isGreaterThan(30);
        assertThat(SonatedScene.db(behind / beside)).isCloseTo((0.5 - 0.0022) * 3.5 * 2 * 3, within(0.8));
    }

    /**
     * Branches of the portal vein run in sheaths of connective tissue and have bright walls; hepatic veins are dark
     * bands without.
     */
    @ParameterizedTest
    @CsvSource({
        "portal_vein_R, true",
        "vessel_portal_vein_L, true",
        "hepatic_vein_R, false",
        "inferior_vena_cava, false"
    })
    void ofTheVeinsInTheLiverThoseOfThePortalVeinHaveBrightWalls(String name, boolean bright) {
        BModeImage image = new SonatedScene()
                .with("liver", StructureKind.LIVER, -10, 190)
                .with(name, StructureKind.VESSEL, 60, 75)
                .image();
        double liver = SonatedScene.mean(image, MIDDLE - 20, MIDDLE + 20, 45, 55);
        double wall = SonatedScene.mean(image, MIDDLE - 4, MIDDLE + 4, 59.7, 60.4);
        double within = SonatedScene.mean(image, MIDDLE - 20, MIDDLE + 20, 64, 71);
        assertThat(SonatedScene.db(liver / within)).as("blood is dark").isGreaterThan(20);
        // The impedances alone give 20 log 0.0123 = -38 dB of a mirror, 12 dB above the echoes of the liver.
        assertThat(SonatedScene.db(wall / liver) > 22).isEqualTo(bright);
    }

    /** Fully developed speckle: amplitudes are Rayleigh distributed, mean to standard deviation 1.91. */
    @Test
    void liverHasItsEchogenicityAndFullyDevelopedSpeckle() {
        BModeImage image =
                new SonatedScene().with("liver", StructureKind.LIVER, -10, 190).image();
        double intensity = 0;
        double amplitude = 0;
        int count = 0;
        for (int line = 40; line < 216; line++) {
            for (double d = 30; d < 120; d += 0.3) {
                double i = image.intensity(line, d) * Math.pow(10, 0.5 * 3.5 * 2 * d / 100);
                intensity += i;
                amplitude += Math.sqrt(i);
                count++;
            }
        }
        intensity /= count;
        amplitude /= count;
        assertThat(SonatedScene.db(intensity)).isCloseTo(Tissue.LIVER.echogenicityDb(), within(0.5));
        assertThat(amplitude / Math.sqrt(intensity - amplitude * amplitude)).isCloseTo(1.91, within(0.06));
    }

    @Test
    void speckleMovesWithTheTissue() {
        SonatedScene scene =
                new SonatedScene().with("liver", StructureKind.LIVER, Surface.Motion.DEFORMING, -30, -300, 250, 300);
        BModeImage before = scene.image(1, scene.shifted(0, 0, 0), Optional.empty());
        BModeImage after = scene.image(1, scene.shifted(3, 0.05, 0), Optional.empty());
        assertThat(correlation(before, after, 3)).isGreaterThan(0.85);
        assertThat(Math.abs(correlation(before, after, 0))).isLessThan(0.2);
    }

    /** Correlation of amplitudes near the middle, one image taken deeper than the other. */
    private static double correlation(BModeImage a, BModeImage b, double deeper) {
        double[] s = new double[6];
        for (int line = MIDDLE - 6; line < MIDDLE + 6; line++) {
            for (double d = 40; d < 120; d += 0.3) {
                double x = Math.sqrt(a.intensity(line, d)) * Math.pow(10, 0.5 * 3.5 * 2 * d / 200);
                double y = Math.sqrt(b.intensity(line, d + deeper)) * Math.pow(10, 0.5 * 3.5 * 2 * d / 200);
                s[0]++;
                s[1] += x;
                s[2] += y;
                s[3] += x * x;
                s[4] += y * y;
                s[5] += x * y;
            }
        }
        double covariance = s[5] - s[1] * s[2] / s[0];
        return covariance / Math.sqrt((s[3] - s[1] * s[1] / s[0]) * (s[4] - s[2] * s[2] / s[0]));
    }

    @Test
    void lungRepeatsItsLineBelowAtTwiceItsDepth() {
        BModeImage image = new SonatedScene()
                .with("skin", StructureKind.SKIN, -10, 190)
                .with("lung_R", StructureKind.LUNG, 30, 180)
                .image();
        double line = image.intensity(MIDDLE, 30);
        double again = image.intensity(MIDDLE, 60);
        assertThat(again).isLessThan(line).isGreaterThan(100 * image.intensity(MIDDLE, 50));
        assertThat(image.intensity(MIDDLE, 90)).isLessThan(again);
    }

    /** Behind any part of the skin there is gas, as behind the only one. */
    @Test
    void aFurtherSkinBesideTheImageLeavesItAsItIs() {
        SonatedScene scene = new SonatedScene().with("skin_arm_R", StructureKind.SKIN, -10, 30);
        BModeImage alone = scene.image();
        scene.with("skin_torso", StructureKind.SKIN, 500, 600);
        assertThat(scene.image().grey()).isEqualTo(alone.grey());
        assertThat(alone.intensity(MIDDLE, 30)).isGreaterThan(100 * alone.intensity(MIDDLE, 25));
    }

    /** A hole leaves an organ its inside; half a sphere has none. */
    @Test
    void surfacesWithHolesAreSeenAndOpenOnesAreNamed() {
        TriangleMesh ball = Shapes.sphere(40, 3);
        int[] t = ball.triangles();
        Surface holed = surface("liver", new TriangleMesh(ball.positions(), Arrays.copyOf(t, t.length - 30)));
        int[] upper = IntStream.range(0, t.length)
                .filter(i -> ball.z(t[i / 3 * 3]) > 0)
                .map(i -> t[i])
                .toArray();
        Surface half = surface("spleen", new TriangleMesh(ball.positions(), upper));
        Surface pleura = new Surface(
                "pleura_R", StructureKind.PLEURA, 0, Side.RIGHT, half.rest(), Surface.Motion.STILL, new boolean[0]);
        List<Surface> surfaces = List.of(holed, half, pleura);
        Ultrasound ultrasound = new Ultrasound(surfaces, CurvilinearProbe.abdominal(), 1);
        assertThat(ultrasound.leftOut()).containsExactly("spleen");
        ProbePose pose = ProbePose.onSkin(new double[] {-60, 0, 0}, new double[] {-1, 0, 0}, ProbePose.Angles.ZERO, 0);
        BModeImage image = ultrasound.take(Frame.still(surfaces), pose, SonatedScene.SETTINGS, Optional.empty());
        double inside = SonatedScene.mean(image, MIDDLE - 10, MIDDLE + 10, 40, 80);
        assertThat(SonatedScene.db(inside)).isGreaterThan(Tissue.LIVER.echogenicityDb() - 20);
    }

    private static Surface surface(String name, TriangleMesh mesh) {
        StructureKind kind = name.equals("liver") ? StructureKind.LIVER : StructureKind.ORGAN;
        return new Surface(name, kind, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    /** The bits do not depend on the number of threads, nor on what the same object took before. */
    @Test
    void imageIsTheSameOnAnyNumberOfThreads() {
        SonatedScene scene = new SonatedScene()
                .with("skin", StructureKind.SKIN, Surface.Motion.DEFORMING, 0, -150, 200, 150)
                .with("rib_08_R", StructureKind.RIB, Surface.Motion.STILL, 15, -30, 21, -18)
                .with("liver", StructureKind.LIVER, Surface.Motion.DEFORMING, 30, -120, 140, 120);
        Frame frame = scene.shifted(1, 2, 3);
        SonatedNeedle needle = SonatedScene.needleAcross(60, 1, 20);
        BModeImage one = scene.image(1, frame, Optional.of(needle));
        Ultrasound three = new Ultrasound(scene.surfaces, CurvilinearProbe.abdominal(), 3);
        ProbePose other = ProbePose.onSkin(new double[3], new double[] {-1, 0, 0}, new ProbePose.Angles(40, 9, 5), 3);
        three.take(scene.shifted(9, 0, 0), other, SonatedScene.SETTINGS.withDepth(90), Optional.empty());
        BModeImage again = three.take(frame, SonatedScene.POSE, SonatedScene.SETTINGS, Optional.of(needle));
        assertThat(again.grey()).isEqualTo(one.grey());
        assertThat(SonatedScene.mean(again, 0, 256, 0, 150)).isEqualTo(SonatedScene.mean(one, 0, 256, 0, 150));
    }
}
