package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Shapes;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

class PathAdviceTest {
    /**
     * A level path of a needle of 0.6 mm radius. At z = -20 the lung is 30 mm away, rib 9 is 10 mm away, and the lower
     * face of rib 8, whose vessels take 5 mm, is 50 mm away. At z = 5 these are 5, 35 and 25 mm.
     */
    @ParameterizedTest
    @CsvSource({
        "-20, LUNG, 29.4 mm from right lung",
        "-20, BONE, 9.4 mm from right rib 9",
        "5, LUNG, 4.4 mm from right lung",
        "5, BONE, 24.4 mm from right rib 8",
        "5, VESSELS, 20.0 mm from the vessels below right rib 8",
        "5, ORGAN, no structure at risk within 40 mm"
    })
    void theMarginNamesTheAvoidedStructureThatItIsMeasuredFrom(double z, NoGoZone avoided, String margin) {
        assertThat(PathAdvice.of(level(new BoxAnatomy(), z, avoided)).margin()).isEqualTo(margin);
    }

    /** As {@link #theMarginNamesTheAvoidedStructureThatItIsMeasuredFrom}, where the scan shows some of it. */
    @ParameterizedTest
    @CsvSource({
        "-20, LUNG, lung_R, right lung",
        "-20, BONE, lung_R, ",
        "-20, BONE, rib_09_R, right rib 9",
        "5, VESSELS, rib_08_R, right rib 8",
        "5, VESSELS, lung_R, ",
        "-20, LUNG, part of the lungs, part of the lungs",
        "-20, BONE, part of the lungs, ",
        "5, VESSELS, part of the rib 08 R, part of the rib 08 R",
        "-20, BONE, liver, liver",
        "-20, BONE, part of the liver, part of the liver",
        "-20, BONE, skin, skin"
    })
    void skinLiverAndWhatAMarginIsMeasuredFromAreNamedIfTheyAreNotInTheScan(
            double z, NoGoZone avoided, String notInScan, String named) {
        BoxAnatomy body = new BoxAnatomy();
        PathOverBreath path = level(body, z, avoided);
        PathAdvice seen = PathAdvice.of(path, new BodySurfaces(body.surfaces));
        PathAdvice unseen = PathAdvice.of(path, new BodySurfaces(body.surfaces, Set.of(notInScan), notInScan));
        if (named == null) {
            assertThat(unseen).isEqualTo(seen);
        } else {
            assertThat(unseen.level()).isEqualTo(PathAdvice.Level.CAREFUL);
            assertThat(unseen.reasons()).hasSize(1 + seen.reasons().size());
            assertThat(unseen.reasons()).last().isEqualTo("not in the scan, and so not of this person: " + named);
        }
        assertThat(seen.reasons()).singleElement().asString().startsWith("not in this body");
    }

    /** As two lobes of a lung. */
    @Test
    void oneOfTwoStructuresWithOneLabelIsNamed() {
        BoxAnatomy body = new BoxAnatomy();
        Surface rib = body.surfaces.get(3);
        body.surfaces.add(new Surface(
                "rib_09_R_far",
                rib.kind(),
                rib.level(),
                rib.side(),
                Shapes.moved(rib.rest(), 0, 0, 300),
                Surface.Motion.STILL,
                new boolean[0]));
        PathOverBreath path = level(body, -20, NoGoZone.BONE);
        assertThat(remark(path, body, "rib_09_R")).endsWith(": right rib 9");
        assertThat(remark(path, body, "rib_09_R_far")).startsWith("not in this body");
    }

    private static String remark(PathOverBreath path, BoxAnatomy body, String notInScan) {
        List<String> reasons = PathAdvice.of(path, new BodySurfaces(body.surfaces, Set.of(notInScan), notInScan))
                .reasons();
        return reasons.get(reasons.size() - 1);
    }

    private static PathOverBreath level(BoxAnatomy body, double z, NoGoZone avoided) {
        MovingAnatomy scene = new MovingAnatomy(body.surfaces);
        scene.update(body.still(0));
        return PathOverBreath.of(
                scene,
                List.of(new BreathMoment(body.still(0), RespiratoryPhase.PAUSE, 4)),
                new double[] {0, 0, z},
                TargetLesion.at(scene, new double[] {90, 0, z}, 20),
                Needle.standard(),
                EnumSet.of(avoided));
    }

    /** Three breaths in two moments. */
    @Test
    void whatOfTheBreathingIsNotJudgedIsSaid() {
        BoxAnatomy body = new BoxAnatomy();
        MovingAnatomy scene = new MovingAnatomy(body.surfaces);
        scene.update(body.still(0));
        Frame third = body.still(3);
        third.values()[Observation.COLUMNS.indexOf("breath")] = 2;
        List<BreathMoment> breaths = List.of(
                new BreathMoment(body.still(0), RespiratoryPhase.INSPIRATION, 6),
                new BreathMoment(third, RespiratoryPhase.EXPIRATION, 6));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, -20}, 20);
        PathOverBreath path = PathOverBreath.of(
                scene, breaths, new double[] {0, 0, -20}, target, Needle.standard(), NoGoZone.defaults());
        String limits = "judged at 2 moments of 6 s, at least 1 of each breath outside of pauses and holds";
        PathAdvice advice = PathAdvice.of(path, new BodySurfaces(body.surfaces));
        assertThat(advice.level()).isEqualTo(PathAdvice.Level.CAREFUL);
        assertThat(advice.reasons()).hasSize(2).first().isEqualTo(limits);
        assertThat(path.toMap()).containsEntry("limits", limits);
        assertThat(level(body, -20, NoGoZone.LUNG).toMap()).doesNotContainKey("limits");
    }

    /** The target is 90 mm from the entry at rest and 110 mm when the breath has carried it away from the skin. */
    @ParameterizedTest
    @CsvSource({
        "120, FREE, Free over the whole breath, 2",
        "100, CAREFUL, Free in 50 % of the breath, 1",
        "80, BARRED, Barred over the whole breath, 0"
    })
    void aPathThatIsLongerThanTheNeedleIsNotFree(
            double needleMm, PathAdvice.Level level, String headline, int freeMoments) {
        BoxAnatomy body = new BoxAnatomy();
        MovingAnatomy scene = new MovingAnatomy(body.surfaces);
        scene.update(body.still(0));
        Frame inspired = body.frame(1, 0.25, new double[] {20, 0, 0}, 0, 0);
        List<BreathMoment> breath = List.of(
                new BreathMoment(body.still(0), RespiratoryPhase.PAUSE, 4),
                new BreathMoment(inspired, RespiratoryPhase.INSPIRATION, 4));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, -20}, 20);
        Needle needle = new Needle(18, needleMm);
        double[] entry = {0, 0, -20};
        PathOverBreath path = PathOverBreath.of(scene, breath, entry, target, needle, NoGoZone.defaults());
        PathAdvice advice = PathAdvice.of(path);
        assertThat(advice.level()).isEqualTo(level);
        assertThat(advice.headline()).isEqualTo(headline);
        assertThat(path.toMap()).containsEntry("free_moments", freeMoments);
        if (freeMoments == 1) {
            assertThat(advice.reasons()).containsExactly("is longer than the needle of 100 mm: while breathing in");
        }
    }
}
