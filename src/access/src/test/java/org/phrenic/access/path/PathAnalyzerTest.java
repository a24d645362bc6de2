package org.phrenic.access.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.CostalGroove;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.anatomy.StructureKind;

/** What a path meets in a body of boxes, in closed form. */
class PathAnalyzerTest {
    /** Frames hold single precision. */
    private static final double TOLERANCE_MM = 1e-4;

    private final BoxAnatomy body = new BoxAnatomy();
    private final MovingAnatomy scene = new MovingAnatomy(body.surfaces);
    private final PathAnalyzer reader = new PathAnalyzer(scene, Needle.standard());

    private PathAnalysis read(double z) {
        return reader.analyze(new double[] {0, 3, z}, new double[] {90, 3, z});
    }

    @Test
    void depthsOfStackedBoxesAreTheirFaces() {
        scene.update(body.still(0));
        PathAnalysis reading = read(35);
        assertThat(reading.crossings()).extracting(Crossing::name).containsExactly("rib_08_R", "lung_R", "liver");
        double[] faces = {10, 16, 20, 30, 40, 90};
        for (int i = 0; i < 3; i++) {
            assertThat(reading.crossings().get(i).fromMm()).isCloseTo(faces[2 * i], within(TOLERANCE_MM));
            assertThat(reading.crossings().get(i).toMm()).isCloseTo(faces[2 * i + 1], within(TOLERANCE_MM));
        }
        assertThat(reading.noGo()).contains(NoGoZone.BONE, NoGoZone.LUNG);
        assertThat(reading.touches(NoGoZone.defaults())).contains("crosses lung", "crosses right rib 8");
        assertThat(reading.capsuleAngleDeg()).isCloseTo(90, within(1e-3));
    }

    /** The needle is thicker than its path, which runs 0.2 mm below the rib. */
    @Test
    void aPathThroughLungTellsTheBoneThatTheNeedleTouchesToo() {
        scene.update(body.still(0));
        assertThat(read(29.8).touches(Set.of(NoGoZone.LUNG, NoGoZone.BONE)))
                .containsExactly("crosses lung", "touches bone");
    }

    @Test
    void anObliquePathIsLongerByTheCosine() {
        scene.update(body.still(0));
        // 3-4-5: for 4 mm of depth 5 mm of path.
        PathAnalysis reading = reader.analyze(new double[] {0, -30, 0}, new double[] {80, 30, 0});
        Crossing liver = reading.crossing("liver").orElseThrow();
        assertThat(liver.fromMm()).isCloseTo(50, within(TOLERANCE_MM));
        assertThat(liver.lengthMm()).isCloseTo(50, within(TOLERANCE_MM));
        assertThat(reading.capsuleAngleDeg()).isCloseTo(90 - 36.8699, within(1e-3));
    }

    @Test
    void aRigidRibIsMetWhereItsPoseIsAndALungWhereItsVerticesAre() {
        scene.update(body.frame(0, 0, new double[3], 0, -20));
        assertThat(read(15).crossing("rib_08_R").orElseThrow().fromMm()).isCloseTo(10, within(TOLERANCE_MM));
        assertThat(read(35).crossing("rib_08_R")).isEmpty();
        scene.update(body.frame(1, 0, new double[3], 40, 0));
        assertThat(read(-25).crossing("lung_R").orElseThrow().lengthMm()).isCloseTo(10, within(TOLERANCE_MM));
    }

    @Test
    void distancesAndSpaceAreThoseOfTheRibs() {
        scene.update(body.still(0));
        PathAnalysis reading = read(-10);
        assertThat(reading.space().orElseThrow().label()).isEqualTo("8th intercostal space, right");
        assertThat(reading.approaches()).extracting(Approach::name).containsExactly("lung_R", "rib_09_R");
        assertThat(reading.approaches().get(0).distanceMm()).isCloseTo(20, within(TOLERANCE_MM));
        assertThat(reading.approaches().get(0).depthMm()).isBetween(20 - TOLERANCE_MM, 30 + TOLERANCE_MM);
        assertThat(reading.approaches().get(1).distanceMm()).isCloseTo(20, within(TOLERANCE_MM));
        assertThat(reading.noGo()).isEmpty();
        // Lower face of rib 8 at z = 30; of rib 9 at -42.
        assertThat(reading.costalGrooveMm()).isCloseTo(32, within(TOLERANCE_MM));
    }

    /** Both ribs lie on one side of a path that rises behind them, though one is higher and one lower. */
    @Test
    void aWayIsIntercostalOnlyWhereItPassesBetweenTheRibs() {
        scene.update(body.still(0));
        PathAnalysis behind = reader.analyze(new double[] {35, 0, -150}, new double[] {35, 0, -5});
        assertThat(behind.way().label()).isEqualTo("right subcostal");
        assertThat(read(35).way().label()).as("through rib 8").isEqualTo("over a rib or the costal margin");
        assertThat(read(29.8).way().label())
                .as("the needle is thicker than its path")
                .startsWith("over a rib");
        assertThat(read(9).way().label()).isEqualTo("8th intercostal space, right");
        assertThat(read(-9).way().label()).isEqualTo("8th intercostal space, right");
        assertThat(read(-43).way().label()).isEqualTo("right subcostal");
    }

    @Test
    void closeBelowARibAreItsVessels() {
        scene.update(body.frame(0, 0, new double[3], -100, 0));
        assertThat(read(30 - CostalGroove.NEUROVASCULAR_ZONE_MM + 0.1).noGo()).containsExactly(NoGoZone.VESSELS);
        assertThat(read(30 - CostalGroove.NEUROVASCULAR_ZONE_MM - 0.1).noGo()).isEmpty();
        // Over the upper border of a rib there are none.
        assertThat(read(-30 + Needle.standard().radiusMm() + 0.1).noGo()).isEmpty();
        assertThat(read(-30 + Needle.standard().radiusMm() - 0.1).noGo()).containsExactly(NoGoZone.BONE);
    }

    @Test
    void theMarginIsTheDistanceLessTheNeedleOrTheZone() {
        scene.update(body.frame(0, 0, new double[3], -100, 0));
        double[] from = {0, 3, -20};
        double[] to = {90, 3, -20};
        assertThat(reader.margin(from, to, NoGoZone.defaults()).mm())
                .isCloseTo(10 - Needle.standard().radiusMm(), within(TOLERANCE_MM));
        assertThat(reader.margin(from, to, NoGoZone.defaults()).nearest()).isEqualTo("rib_09_R");
        from[2] = 20;
        to[2] = 20;
        assertThat(reader.margin(from, to, NoGoZone.defaults()).mm())
                .isCloseTo(10 - CostalGroove.NEUROVASCULAR_ZONE_MM, within(TOLERANCE_MM));
        assertThat(reader.margin(from, to, NoGoZone.defaults()).nearest()).isEqualTo("vessels_rib_08_R");
    }

    @Test
    void aVesselThatIsTouchedAndNotCrossedHasItsName() {
        scene.update(body.still(0));
        PathAnalysis free = read(-10);
        Approach vessel =
                new Approach("epigastric_R", "right superior epigastric vessels", StructureKind.VESSEL, 0.4, 12);
        PathAnalysis touching = new PathAnalysis(
                0,
                free.lengthMm(),
                free.crossings(),
                free.way(),
                List.of(vessel),
                free.costalGrooveMm(),
                free.costalGrooveRib(),
                free.capsuleAngleDeg(),
                Set.of(NoGoZone.ORGAN));
        assertThat(touching.touches(NoGoZone.defaults())).containsExactly("touches right superior epigastric vessels");
    }
}
