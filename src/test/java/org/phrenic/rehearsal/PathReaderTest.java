package org.phrenic.rehearsal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** What a path meets in a body of boxes, in closed form. */
class PathReaderTest {
    /** Frames hold single precision. */
    private static final double TOLERANCE_MM = 1e-4;

    private final Slabs body = new Slabs();
    private final MovingScene scene = new MovingScene(body.surfaces);
    private final PathReader reader = new PathReader(scene, Needle.usual());

    private PathReading read(double z) {
        return reader.read(new double[] {0, 3, z}, new double[] {90, 3, z});
    }

    @Test
    void depthsOfStackedBoxesAreTheirFaces() {
        scene.take(body.still(0));
        PathReading reading = read(35);
        assertThat(reading.crossings()).extracting(Crossing::name).containsExactly("rib_08_R", "lung_R", "liver");
        double[] faces = {10, 16, 20, 30, 40, 90};
        for (int i = 0; i < 3; i++) {
            assertThat(reading.crossings().get(i).fromMm()).isCloseTo(faces[2 * i], within(TOLERANCE_MM));
            assertThat(reading.crossings().get(i).toMm()).isCloseTo(faces[2 * i + 1], within(TOLERANCE_MM));
        }
        assertThat(reading.noGo()).contains(NoGo.BONE, NoGo.LUNG);
        assertThat(reading.reasons(NoGo.usual())).contains("crosses lung", "crosses right rib 8");
        assertThat(reading.capsuleAngleDeg()).isCloseTo(90, within(1e-3));
    }

    @Test
    void anObliquePathIsLongerByTheCosine() {
        scene.take(body.still(0));
        // 3-4-5: for 4 mm of depth 5 mm of path.
        PathReading reading = reader.read(new double[] {0, -30, 0}, new double[] {80, 30, 0});
        Crossing liver = reading.crossing("liver").orElseThrow();
        assertThat(liver.fromMm()).isCloseTo(50, within(TOLERANCE_MM));
        assertThat(liver.lengthMm()).isCloseTo(50, within(TOLERANCE_MM));
        assertThat(reading.capsuleAngleDeg()).isCloseTo(90 - 36.8699, within(1e-3));
    }

    @Test
    void aRigidRibIsMetWhereItsPoseIsAndALungWhereItsVerticesAre() {
        scene.take(body.frame(0, 0, new double[3], 0, -20));
        assertThat(read(15).crossing("rib_08_R").orElseThrow().fromMm()).isCloseTo(10, within(TOLERANCE_MM));
        assertThat(read(35).crossing("rib_08_R")).isEmpty();
        scene.take(body.frame(1, 0, new double[3], 40, 0));
        assertThat(read(-25).crossing("lung_R").orElseThrow().lengthMm()).isCloseTo(10, within(TOLERANCE_MM));
    }

    @Test
    void distancesAndSpaceAreThoseOfTheRibs() {
        scene.take(body.still(0));
        PathReading reading = read(-10);
        assertThat(reading.space().orElseThrow().label()).isEqualTo("8th intercostal space, right");
        assertThat(reading.approaches()).extracting(Approach::name).containsExactly("lung_R", "rib_09_R");
        assertThat(reading.approaches().get(0).distanceMm()).isCloseTo(20, within(TOLERANCE_MM));
        assertThat(reading.approaches().get(0).depthMm()).isBetween(20 - TOLERANCE_MM, 30 + TOLERANCE_MM);
        assertThat(reading.approaches().get(1).distanceMm()).isCloseTo(20, within(TOLERANCE_MM));
        assertThat(reading.noGo()).isEmpty();
        // Lower face of rib 8 at z = 30; of rib 9 at -42.
        assertThat(reading.borderMm()).isCloseTo(32, within(TOLERANCE_MM));
    }

    @Test
    void closeBelowARibAreItsVessels() {
        scene.take(body.frame(0, 0, new double[3], -100, 0));
        assertThat(read(30 - RibBorder.ZONE_MM + 0.1).noGo()).containsExactly(NoGo.VESSELS);
        assertThat(read(30 - RibBorder.ZONE_MM - 0.1).noGo()).isEmpty();
        // Over the upper border of a rib there are none.
        assertThat(read(-30 + Needle.usual().radiusMm() + 0.1).noGo()).isEmpty();
        assertThat(read(-30 + Needle.usual().radiusMm() - 0.1).noGo()).containsExactly(NoGo.BONE);
    }

    @Test
    void theMarginIsTheDistanceLessTheNeedleOrTheZone() {
        scene.take(body.frame(0, 0, new double[3], -100, 0));
        double[] from = {0, 3, -20};
        double[] to = {90, 3, -20};
        assertThat(reader.margin(from, to, NoGo.usual()))
                .isCloseTo(10 - Needle.usual().radiusMm(), within(TOLERANCE_MM));
        assertThat(reader.nearest()).isEqualTo("rib_09_R");
        from[2] = 20;
        to[2] = 20;
        assertThat(reader.margin(from, to, NoGo.usual())).isCloseTo(10 - RibBorder.ZONE_MM, within(TOLERANCE_MM));
        assertThat(reader.nearest()).isEqualTo("vessels_rib_08_R");
    }
}
